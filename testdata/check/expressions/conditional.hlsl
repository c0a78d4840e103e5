// Before HLSL 2021 both sides of ?: are evaluated, and a vector condition chooses component by component, as select does.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s --check-prefixes=CHECK,BOTH
// RUN: %clipc -T vs_6_0 -HV 2018 -E main --dump=ir %s | FileCheck %s --check-prefixes=CHECK,BOTH
// RUN: %clipc -T vs_6_0 -E main --dump=ir %s | FileCheck %s --check-prefixes=CHECK,ONE
static int calls = 0;
float count(float x) { calls++; return x; }
float4 main(float4 v : POSITION) : SV_Position {
  // CHECK: float a = (v.x > 0.0) ? v.y : 1.0
  float a = v.x > 0 ? v.y : 1;
  // CHECK: float4 b = select(v > splat<float4>(0.0), v, splat<float4>(1.0))
#if __HLSL_VERSION < 2021
  float4 b = v > 0 ? v : 1;
#else
  float4 b = select(v > 0, v, 1);
#endif
  // BOTH: bool temporary = v.x > 0.0
  // BOTH-NEXT: float temporary.1 = count(1.0)
  // BOTH-NEXT: float c = temporary ? temporary.1 : 2.0
  // ONE: float c = (v.x > 0.0) ? count(1.0) : 2.0
  float c = v.x > 0 ? count(1) : 2;
  // BOTH: bool d = (a > 0.0) && (count(a) > 1.0)
  // ONE: bool d = (a > 0.0) and_then (count(a) > 1.0)
  bool d = a > 0 && count(a) > 1;
  return b * a * c * d;
}
