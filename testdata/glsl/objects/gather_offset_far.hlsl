// From 5.0 on the offsets of a Gather have six bits, -32 to 31: gather4_po of the Direct3D 11.3 functional specification, 22.4.3. OpenGL
// has them as far as GL_MAX_PROGRAM_TEXTURE_GATHER_OFFSET says, which is 31 on hardware of Direct3D 11.
// RUN: %clipc -T vs_5_0 --target=glsl450 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=vulkan --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=essl320 --validate %s -o %t
// RUN: %draw compare %s -T vs_5_0 --target glsl450,vulkan
Texture2D map;
SamplerState s;
float4 main(float2 uv : TEXCOORD) : SV_Position {
  // CHECK: textureGatherOffset(map, in_TEXCOORD0, ivec2(20, -31))
  float4 r = map.Gather(s, uv, int2(20, -31));
  for (int i = 28; i < 30; ++i) r += map.GatherGreen(s, uv, int2(i, -i));
  return r + map.GatherRed(s, uv, int2(1, 2), int2(20, 3), int2(-9, 0), int2(0, 8));
}
