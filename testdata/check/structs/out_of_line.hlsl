// Two structs have members of the same names; each takes the definitions outside of it that name it.
// RUN: %clipc -T vs_5_0 -E main %s -o - | FileCheck %s
struct First {
  static int count;
  float value(float x);
};
struct Second {
  static int count;
  float value(float x);
};
int Second::count = 20;
int First::count = 10;
float Second::value(float x) { return x * 200; }
float First::value(float x) { return x * 100; }

// CHECK: {{^}}int count = 10;
// CHECK-NEXT: {{^}}int count_2 = 20;
// CHECK: float value(First self, float x) {
// CHECK-NEXT: return x * 100.0;
// CHECK: float value(Second self, float x) {
// CHECK-NEXT: return x * 200.0;
float4 main(float4 position : POSITION) : SV_Position {
  First first;
  Second second;
  First::count += 1;
  Second::count += 1;
  return position * first.value(First::count) * second.value(Second::count);
}
