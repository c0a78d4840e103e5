// Before 5.1 the registers of unordered access views without one follow the render targets. Oracle: vkd3d's
// uav-rwtexture.shader_test, checked against fxc.
// RUN: %clipc -T ps_5_0 %s --dump=ir | FileCheck --check-prefix=OLD %s
// RUN: %clipc -T ps_5_1 %s --dump=ir | FileCheck --check-prefix=NEW %s
// OLD: resource RWTexture2D<float4> first : u3
// OLD: resource RWTexture2D<float4> second : u4
// NEW: resource RWTexture2D<float4> first : u0
// NEW: resource RWTexture2D<float4> second : u1
RWTexture2D<float4> first, second;

void main(out float4 a : SV_Target, out float4 b : SV_Target2) {
  first[uint2(0, 0)] = 1;
  second[uint2(0, 0)] = 2;
  a = b = 0;
}
