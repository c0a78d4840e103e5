// `using namespace` makes the functions of a namespace overloads of those of others and of the scope around both ([namespace.udir] of C++); those of a scope further in hide them. In a function it holds in its block.
// RUN: %clipc %s -T vs_6_0 -o - | FileCheck %s
// RUN: %draw compare %s -T vs_6_0
namespace A {
float Which(int x) { return 1; }
float Own(int x) { return 10; }
typedef float4 Colour;
}
namespace B {
float Which(float x) { return 2; }
typedef float4 Colour;
}
namespace C {
using namespace A;
using namespace B;
float Own(float x) { return 20; }
float Inside(int x) { return Own(x) + Which(x) + Which(x * 0.5); }
}
float Own(float2 x) { return 30; }
float InBlock(int x) {
  float sum = 0;
  {
    using namespace A;
    sum += Which(x);
  }
  {
    using namespace B;
    sum += 100 * Which(x);
  }
  return sum;
}
// CHECK: return Own(float(x)) + Which(x) + Which(float(x) * 0.5);
// CHECK: sum += Which(x);
// CHECK: sum += 100.0 * Which(float(x));
// CHECK: Which(in_I0), Which(in_P0.x), Own(in_I0), Own(in_P0.xy)
float4 main(float4 p : P, int i : I) : SV_Position {
  using namespace A;
  using namespace B;
  Colour c = p;
  return float4(Which(i), Which(p.x), Own(i), Own(p.xy)) + C::Inside(i) + C::Which(i) + InBlock(i) + c;
}
