// The functions of packed bytes of shader model 6.4 and 6.6. Oracle: the Direct3D specifications "Shader Model 6.4" (dot2add,
// dot4add_u8packed, dot4add_i8packed) and "Shader Model 6.6 Pack/Unpack Math Intrinsics".
// RUN: %clipc -T vs_6_6 --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_6_6 --target glsl330,glsl450,essl300,vulkan
// CHECK: uint a = dot4add_u8packed(in_I0.x, in_I0.y, in_I0.z);
// CHECK: int b = dot4add_i8packed(in_I0.x, in_I0.y, -3);
// CHECK: uint packed_ = pack_u8(in_I0);
float4 main(float4 p : POSITION, uint4 i : I, int4 j : J) : SV_Position {
  uint a = dot4add_u8packed(i.x, i.y, i.z);
  int b = dot4add_i8packed(i.x, i.y, -3);
  float c = dot2add((half2)p.xy, (half2)p.zw, p.x);
  uint8_t4_packed packed = pack_u8(i);
  int8_t4_packed with_signs = pack_s8(j);
  uint8_t4_packed small = pack_clamp_u8(j * 100);
  int8_t4_packed small_signs = pack_clamp_s8(j * 100);
  uint4 bytes = unpack_u8u32(packed) + unpack_u8u16(small);
  int4 numbers = unpack_s8s32(with_signs) - unpack_s8s16(small_signs) + unpack_s8s32(i.w);
  return p + (float)(a & 65535) + (b & 65535) + c + bytes + numbers + unpack_u8u32(uint(small)) + unpack_s8s32(i.x);
}
