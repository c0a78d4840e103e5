// A variable, an enumerator or a type of two namespaces is not one thing.
// RUN: not %clipc %s -T vs_6_0 2>&1 | FileCheck %s --implicit-check-not=error:
namespace A {
static const float K = 1;
struct T { float x; };
float Mixed(float x) { return x; }
}
namespace B {
static const float K = 2;
struct T { float y; };
static const float Mixed = 3;
}
using namespace A;
using namespace B;
float4 main(float4 p : P) : SV_Position {
  // CHECK: [[#@LINE+1]]:3: error: `T` means several things here; write the namespace before it [ambiguous-name, X3067]
  T t;
  // CHECK: [[#@LINE+3]]:14: error: `K` means several things here
  // CHECK: [[#@LINE-15]]:20: note: `K` is declared here
  // CHECK: [[#@LINE-11]]:20: note: `K` is declared here
  return p * K + B::K;
}
