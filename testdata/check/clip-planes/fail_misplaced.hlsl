// RUN: not %clipc -T vs_5_0 %s -o - 2>&1 | FileCheck %s
// Clip planes anywhere but at a function are an error, reached or not.
cbuffer Planes { float4 p; };

// CHECK: fail_misplaced.hlsl:[[#@LINE+1]]:1: error: `clipplanes` is given to the definition of a type; clip planes belong to the entry function, before its return type [clip-planes-misplaced]
[clipplanes(p)] struct Whole { float4 a; };
// CHECK: :[[#@LINE+1]]:8: error: `clipplanes` is given to the definition of a type
struct [clipplanes(p)] Named { float4 a; };
// CHECK: :[[#@LINE+1]]:16: error: `clipplanes` is given to a field
struct Field { [clipplanes(p)] float4 a; };
// CHECK: :[[#@LINE+1]]:1: error: `clipplanes` is given to a variable
[clipplanes(p)] float4 variable;
// CHECK: :[[#@LINE+1]]:1: error: `clipplanes` is given to a `cbuffer`
[clipplanes(p)] cbuffer Buffer { float4 b; };
// CHECK: :[[#@LINE+1]]:18: error: `clipplanes` is given to a variable
cbuffer Member { [clipplanes(p)] float4 m; };
// CHECK: :[[#@LINE+1]]:1: error: `clipplanes` is given to a `typedef`
[clipplanes(p)] typedef float4 Vector;
// CHECK: :[[#@LINE+1]]:1: error: `clipplanes` is given to a `namespace`
[clipplanes(p)] namespace N { float4 n; }
// CHECK: :[[#@LINE+1]]:11: error: `clipplanes` is given to a parameter
float4 of([clipplanes(p)] float4 v) { return v; }
// CHECK: :[[#@LINE+1]]:1: error: `Clip_Planes` is given to a variable
[Clip_Planes(p)] Texture2D<float4> t;

float4 main(float4 v : POSITION) : SV_Position {
  // CHECK: :[[#@LINE+1]]:3: error: `clipplanes` is given to a statement
  [clipplanes(p)] for (int i = 0; i < 2; i++) v += i;
  // CHECK: :[[#@LINE+2]]:3: error: `clipplanes` is given to a statement
  // CHECK: :[[#@LINE+1]]:35: error: `clipplanes` is given to a statement
  [clipplanes(p)] if (v.x) ; else [clipplanes(p)] v = 1;
  // CHECK: :[[#@LINE+1]]:3: error: `clipplanes` is given to a statement
  [clipplanes(p)] float4 local = v;
  return local;
}
