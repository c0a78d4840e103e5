// A static member may have its initial value outside of its struct.
// RUN: %clipc -T vs_5_0 %s --validate | FileCheck %s
struct Counter {
  static int count;
  static const float weights[2];
  int Next() { return count++; }
};
static const int kFirst = 5;
// CHECK: const float weights[2] = float[2](0.25, 0.75);
// CHECK: int count = kFirst;
static int Counter::count = kFirst;
static const float Counter::weights[2] = {0.25, 0.75};
float4 main(float4 p : POSITION) : SV_Position {
  Counter counter;
  return p * counter.Next() + Counter::weights[1];
}
