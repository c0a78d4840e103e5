// A function that its namespace only declares may be defined outside of it (DXC's test namespace.functions.hlsl).
// RUN: %clipc %s -T ps_6_0 -o - | FileCheck %s
namespace A {
static const float kScale = 3;
float3 G();
namespace B {
float F(float x);
float F(int x);
}
}
float4 main(float4 p : P, nointerpolation int i : I) : SV_Target { return float4(A::G(), A::B::F(p.x) + A::B::F(i)); }
// CHECK-DAG: return vec3(kScale);
float3 A::G() { return kScale; }
// CHECK-DAG: return x * kScale;
float A::B::F(float x) { return x * kScale; }
// CHECK-DAG: return 7.0;
float A::B::F(int x) { return 7; }
