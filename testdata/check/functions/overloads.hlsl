// The overload with the cheapest conversions is called; a user's function comes before a built-in one.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
struct S { float x; };
float4 by_type(float x) { return 1; }
float4 by_type(float3 x) { return 3; }
float4 by_type(int x) { return 4; }
float4 by_type(S x) { return 5; }
float4 by_type(float x, float y) { return 6; }
float fmod(float x, float y) { return x; }
float4 main(float4 position : POSITION, uint id : SV_VertexID) : SV_Position {
  S s = {1};
  // CHECK: float4 sum = {{.*}}by_type(1) + by_type.1(1.0)){{.*}} + by_type.2(position.xyz)) + by_type.3(s)) + by_type.4(1.0, 2.0)
  float4 sum = by_type(1) + by_type(1.0) + by_type(position.xyz) + by_type(s) + by_type(1, 2);
  // CHECK: sum += splat<float4>(fmod(1.0, 2.0))
  sum += fmod(1, 2);
  // CHECK: sum += splat<float4>(fmod(position.x, position.x))
  sum += fmod(position, position);
  // CHECK: sum += by_type(convert<int>(id))
  sum += by_type(id);
  return sum;
}
// CHECK: float4 by_type(int x)
// CHECK: float4 by_type.1(float x.1)
