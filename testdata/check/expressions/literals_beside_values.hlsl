// From 6.0 on a literal without a suffix is what the value beside it is: DXC's CombineBasicTypes, CheckBinOpForHLSL ("For case like
// 1<<x"), and constant.scalar.64bit.hlsl of its CodeGenSPIRV for the doubles.
// RUN: %clipc -T vs_6_0 --dump-after=resolve-objects %s | FileCheck %s
// RUN: %clipc -T vs_5_0 --dump-after=resolve-objects %s | FileCheck %s --check-prefix=OLD
cbuffer C { int i; uint n; bool b; double d; float f; };
float4 main() : SV_Position {
  // CHECK: int sum = i + -1294967296
  // OLD: int sum = i + -1294967296
  int sum = i + 3000000000;
  // CHECK-NEXT: bool more = i > -65536
  // OLD-NEXT: bool more = convert<uint>(i) > 4294901760u
  bool more = i > 0xffff0000;
  // CHECK-NEXT: float chosen = convert<float>(b ? -1 : i)
  float chosen = b ? 0xffffffff : i;
  // CHECK-NEXT: float alone = 4294967296.0
  float alone = 0xffffffff;
  // CHECK-NEXT: float bits = convert<float>(1u << n)
  float bits = 1 << n;
  // CHECK-NEXT: uint ones = 4294967295u >> n
  uint ones = -1 >> n;
  // CHECK-NEXT: int kept = -1 >> i
  int kept = 0xffffffff >> i;
  // CHECK-NEXT: double tenth = d * 0.1L
  // OLD: double tenth = d * 0.10000000149011612L
  double tenth = d * 0.1;
  // CHECK-NEXT: double large = -1234567898765.32L
  double large = -1234567898765.32;
  // CHECK-NEXT: double rounded = d * 0.10000000149011612L
  double rounded = d * 0.1f;
  // CHECK-NEXT: float plain = f * 0.1
  float plain = f * 0.1;
  return float4(sum + more + chosen, alone + bits, ones + kept, tenth + large + rounded + plain);
}
