// From 6.0 on a decimal literal of 2^31 and more has its value, negated and in sums of literals too, and takes the type beside it, as "literal int" of DXC does. Enumerators of 64 bits keep them.
// RUN: %clipc %s -T vs_6_0 --target=vulkan -o - | FileCheck %s
// RUN: %clipc %s -T vs_5_0 -DFXC -o - | FileCheck %s --check-prefix=FXC
#ifdef FXC
// FXC: float(-(-1294967296)){{.*}} + in_P0 * -1294967296.0;
float4 main(float4 p : P) : SV_Position { return float4(-3000000000, -3000000000, -3000000000, -3000000000) + p * 3000000000; }
#else
enum E : int64_t { A = 1, B = 0x100000000, C };
// CHECK-DAG: const float s = -4e+09;
static const float s = -4000000000;
float4 main(float4 p : P, int64_t k : K, uint u : U) : SV_Position {
  // CHECK-DAG: vec4 v = vec4(-3e+09, 6e+09, -3e+09, 1.0);
  float4 v = float4(-3000000000, 3000000000 * 2, 0 - 3000000000, 3000000000 / 2500000000);
  // CHECK-DAG: in_K0 / 3000000000l
  v.x += k / 3000000000;
  // CHECK-DAG: in_K0 < 3000000000l
  v.y += k < 3000000000;
  // CHECK-DAG: in_U0 * 2654435769u
  v.z += u * 2654435769;
  // CHECK-DAG: in_U0 + 1294967296u
  v.w += u + -3000000000;
  // CHECK-DAG: int64_t q = 4294967297l;
  int64_t q = C;
  // CHECK-DAG: vec4 wide = vec4(-5e+09, 1e+10, 1.0, -5e+09);
  float4 wide = float4(-5000000000, 5000000000 * 2, 5000000001 - 5000000000, -5000000000);
  // CHECK-DAG: wide.x += float(in_K0 < -5000000000l)
  wide.x += k < -5000000000;
  return v * s + (float)q + wide;
}
#endif
