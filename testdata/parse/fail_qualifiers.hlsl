// Qualifiers where they have no place, and pairs that contradict each other. What fxc says of each at
// each kind of declaration is in DXC's varmods-syntax.hlsl and typemods-syntax_noerr.hlsl.
// RUN: not %clipc -T vs_5_0 -E helper %s 2>&1 | grep -v '^ ' | FileCheck %s

// CHECK: [[#@LINE+1]]:11: error: a global variable cannot be `in`; this is as in GLSL, and clipc reads HLSL [qualifier-misplaced, X3006]
in float4 read;
// CHECK-NEXT: [[#@LINE+1]]:14: error: a global variable cannot be `inout`
inout float4 both;
// CHECK-NEXT: [[#@LINE+1]]:16: warning: `volatile` has no effect on a global variable [-Wqualifier-without-effect]
volatile float changing;
// CHECK-NEXT: [[#@LINE+1]]:24: warning: `linear` has no effect on a global variable
linear centroid float4 interpolated, another;
// CHECK-NEXT: [[#@LINE-1]]:24: warning: `centroid` has no effect on a global variable

// CHECK-NEXT: [[#@LINE+1]]:21: error: `static` and `extern` are used together; remove one of them [qualifier-conflict, X3048]
extern static float elsewhere;
// CHECK-NEXT: [[#@LINE+1]]:23: error: `static` and `uniform` are used together
uniform static float4 color;
// CHECK-NEXT: [[#@LINE+1]]:27: error: `groupshared` and `uniform` are used together
groupshared uniform float group;
// CHECK-NEXT: [[#@LINE+1]]:26: error: `groupshared` and `extern` are used together
groupshared extern float shared_;
// CHECK-NEXT: [[#@LINE+1]]:33: error: `row_major` and `column_major` are used together
row_major column_major float4x4 world;
// CHECK-NEXT: [[#@LINE+1]]:45: error: `snorm` and `unorm` are used together
Buffer<snorm float> good; unorm snorm float number;

struct Fields {
  // CHECK-NEXT: [[#@LINE+1]]:18: error: a field cannot be `uniform`
  uniform float4 a;
  // CHECK-NEXT: [[#@LINE+1]]:16: warning: `const` has no effect on a field
  const float4 b;
  static const float kGood = 1;
  nointerpolation float4 c, d;
  // CHECK-NEXT: [[#@LINE+1]]:40: error: `nointerpolation` and `noperspective` are used together
  nointerpolation noperspective float4 e;
  // CHECK-NEXT: [[#@LINE+1]]:17: warning: `extern` has no effect on a method
  extern float4 f() { return 1; }
};

// CHECK-NEXT: [[#@LINE+1]]:23: error: a typedef cannot be `static`
typedef static float4 Static, Twice[2];
// CHECK-NEXT: [[#@LINE+1]]:24: warning: `precise` has no effect on a typedef
typedef precise float4 Precise;
// CHECK-NEXT: [[#@LINE+1]]:7: error: a typedef cannot be `uniform`
using Uniform = uniform float4;

// CHECK-NEXT: [[#@LINE+1]]:16: error: a function cannot be `uniform`
uniform float4 helper(
    // CHECK-NEXT: [[#@LINE+1]]:19: error: a parameter cannot be `static`
    static float4 a,
    // CHECK-NEXT: [[#@LINE+1]]:9: error: `out` repeats a qualifier before it; remove one of them [qualifier-twice, X3048]
    out out float4 b, in out float4 c,
    // CHECK-NEXT: [[#@LINE+1]]:12: error: `inout` repeats a qualifier before it
    in out inout float4 d,
    // CHECK-NEXT: [[#@LINE+1]]:5: warning: `volatile` has no effect on a parameter
    volatile float4) {
  // CHECK-NEXT: [[#@LINE+1]]:17: error: a local variable cannot be `extern`
  extern float4 x;
  // CHECK-NEXT: [[#@LINE+1]]:18: error: a local variable cannot be `uniform`
  uniform float4 y = 1;
  // CHECK-NEXT: [[#@LINE+1]]:21: error: a local variable cannot be `groupshared`
  groupshared float z, w;
  return a;
}

float4 main(float4 p : POSITION) : SV_Position { return p; }
// CHECK-NOT: {{error|warning}}
