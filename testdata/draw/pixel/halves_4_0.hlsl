// Functions of bits that fxc expands for 4.0, though its documents name 5.0. Oracle: vkd3d's f16tof32, f32tof16 and
// bitwise.shader_test, checked against fxc.
// RUN: %draw compare %s -T ps_4_0 --target glsl450,glsl330,essl300,vulkan
// RUN: %draw compare %s -T ps_5_0 --target glsl450,glsl330,essl300,vulkan
float4 main(float2 a : A, nointerpolation uint2 packed : PACKED) : SV_Target {
  const uint2 halves = f32tof16(a);
  return float4(f16tof32(halves), f16tof32(packed.x & 0x3fff), countbits(packed.y) + firstbitlow(packed.x) + firstbithigh(packed.y));
}
