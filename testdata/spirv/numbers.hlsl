// min, max, clamp and saturate give the operand that is a number: min and max of the Direct3D 11.3 functional specification, native
// results in vkd3d's test_shader_instructions (ps_min_max), "Intrinsic Functions" of DXC's SPIR-V.rst.
// RUN: %clipc -T vs_5_0 -S %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target=vulkan
struct Output {
  float4 position : SV_Position;
  float4 bounds : BOUNDS;
  float2 clamps : CLAMPS;
};
float none;
Output main(float4 p : POSITION) {
  Output o;
  const float nan = none * p.x / (none * p.y);
  o.position = p;
  // CHECK-DAG: NMin
  // CHECK-DAG: NMax
  // CHECK-DAG: NClamp
  // CHECK-NOT: {{FMin|FMax|FClamp}}
  o.bounds = float4(min(nan, p.x), min(p.y, nan), max(nan, p.z), max(p.w, nan));
  o.clamps = float2(clamp(nan, 1, 3), saturate(nan));
  return o;
}
