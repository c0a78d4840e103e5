// The size of an array type, as DXC has it: the bytes of its components.
// RUN: %clipc -T ps_6_0 %s -o - | FileCheck %s
struct S {
  float3 a;
  double b;
};
template<typename T> uint Twice() { return sizeof(T[2]); }
float4 main() : SV_Target {
  // CHECK: vec4(32.0, 216.0, 40.0, float(Twice()))
  return float4(sizeof(float4[2]), sizeof(float3x3[2][3]), sizeof(S[2]), Twice<S>());
}
