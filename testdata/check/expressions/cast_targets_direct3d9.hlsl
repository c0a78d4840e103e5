// Up to shader model 3 a cast that is assigned to may change the type of the components. The outermost cast converts the value, and
// the casts inside it, and under a swizzle, change nothing: vkd3d's lhs-cast.shader_test and lhs-partial-assignment.shader_test.
// RUN: %clipc -T vs_3_0 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T vs_3_0
float4 main(float4 p : POSITION, float f : F) : POSITION {
  int k = 2;
  // CHECK: float temporary = in_F0 * 3.5;
  // CHECK-NEXT: k = int(temporary);
  (float)k = f * 3.5;
  float4 q = p;
  // CHECK: vec4 temporary_2 = vec4(1.25, -2.5, 3.5, in_F0);
  (float2x2)(int4)(half4)q = float4(1.25, -2.5, 3.5, f);
  float4 r = 0, s = 0;
  // CHECK: r.xy = vec2(ivec2(
  ((int4)r).xy = p.zw * 1.75;
  // CHECK: s.xy = in_POSITION0.xy;
  ((float3)((int4)s).xyz).xy = p.xy;
  float sum = ((float)k = 2.5);
  return q + r + s + k + sum;
}
