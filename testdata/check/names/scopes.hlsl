// What a name means: the innermost declaration before the use; functions are declared before, and may be defined later.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
static const float depth = 1;
namespace outer {
static const float depth = 2;
float own() { return depth; }
namespace inner {
float own() { return depth + outer::own() + ::depth; }
}
enum Plain { kZero, kTwo = 2, kThree };
}
namespace outer { float again() { return own() + depth; } }
enum class Strict : uint { kLow = 7, kHigh };
namespace user {
using namespace outer;
float used() { return own(); }
}
float shadow(float depth) {
  { float depth = 5; depth += 1; }
  return depth;
}
// The global that is declared after `early` is not seen there.
float early() { return depth; }
float later(float x);
float4 main(float4 position : POSITION) : SV_Position {
  float sum = outer::own() + outer::inner::own() + outer::again() + user::used();
  sum += outer::kTwo + outer::Plain::kThree + uint(Strict::kHigh) + later(sum) + early() + shadow(1);
  return position * sum;
}
float later(float x) { return x * 2; }
// CHECK-DAG: const float depth.2 = 1.0
// CHECK-DAG: const float depth.1 = 2.0
// CHECK: sum += ((convert<float>(convert<uint>(2 + 3) + 8u) + later(sum)) + early()) + shadow(1.0)
// CHECK: float own() {
// CHECK-NEXT: return depth.1
// CHECK: float own.1() {
// CHECK-NEXT: return (depth.1 + own()) + depth
// CHECK: float again() {
// CHECK-NEXT: return own() + depth.1
// CHECK: float later(
// CHECK: float early() {
// CHECK-NEXT: return depth
// CHECK: float shadow(
// CHECK: += 1.0
