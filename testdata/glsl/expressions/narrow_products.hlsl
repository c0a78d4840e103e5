// Columns and rows of a matrix that make components which nothing reads are left out of a product.
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 %s --target=essl100 --validate -o %t
// RUN: %draw compare %s -T vs_5_0
cbuffer C { float4x4 world; float4x3 bone; row_major float4x4 view; };
float4 main(float4 p : POSITION, float3 n : NORMAL) : SV_Position {
  // CHECK: vec3 a = in_NORMAL0 * mat3(c.world);
  float3 a = (float3)mul(world, n);
  // CHECK-NEXT: vec3 b = mat3(c.world) * in_NORMAL0;
  float3 b = mul(n, world).xyz;
  // CHECK-NEXT: vec2 d = (in_NORMAL0 + a) * mat2x3(c.view);
  float2 d = mul(view, n + a).xy;
  // CHECK-NEXT: vec3 e = (in_NORMAL0 * mat4x3(c.world)).yzx;
  float3 e = mul(world, n).yzx;
  // CHECK-NEXT: float f = (in_NORMAL0 * mat4x3(c.world)).x;
  float f = mul(world, n).x;
  // CHECK-NEXT: vec2 g = in_NORMAL0 * mat2x3(c.bone);
  float2 g = mul((float3x3)bone, n).xy;
  return p + float4(a + b + e, d.x + d.y + f + g.x + g.y);
}
