// RUN: not %clipc -T vs_5_0 -E main %s 2>&1 | FileCheck %s
struct S { float4 x; SamplerState s; };
cbuffer C { float4 color; float4x4 m; float list[3]; };
static const float kOne = 1;
Texture2D one, two;
// CHECK: error: `name` is a string; a shader computes with numbers only [string-used, X3020]
string name = "x";
void nothing() {}
float4 main(float4 v : POSITION, const float fixed : FIXED) : SV_Position {
  S s;
  // CHECK: [[#@LINE+1]]:6: error: `.xg` does not name components of a `float4` [bad-swizzle, X3018]
  v. xg;
  // CHECK: [[#@LINE+1]]:8: error: `.z` does not name components of a `float2` [bad-swizzle, X3018]
  v.xy.z;
  // CHECK: [[#@LINE+1]]:5: error: `._m04` does not name components of a `float4x4` [bad-swizzle, X3018]
  m._m04;
  // CHECK: [[#@LINE+1]]:3: error: components are repeated; each can be assigned only once [swizzle-repeats, X3025]
  v.xx = v.xy;
  // CHECK: [[#@LINE+1]]:3: error: `color` is set by the application; a shader cannot assign to it; `static` makes a variable of the shader's own [uniform-assigned, X3025]
  color.x = 1;
  // CHECK: [[#@LINE+1]]:3: error: `kOne` is constant; it cannot be assigned to [const-assigned, X3025]
  kOne += 1;
  // CHECK: [[#@LINE+1]]:5: error: `fixed` is constant; it cannot be assigned to [const-assigned, X3025]
  ++fixed;
  // CHECK: [[#@LINE+1]]:3: error: this cannot be assigned to; a variable, a member or components of one can [not-assignable, X3025]
  (v + 1) = v;
  // CHECK: [[#@LINE+1]]:8: error: index 3 of a `float[3]` is out of bounds; it has 3 elements [index-out-of-bounds, X3504]
  list[3];
  // CHECK: [[#@LINE+1]]:8: error: the index has type `float2`; it must be a scalar [index-not-scalar, X3120]
  list[v.xy];
  // CHECK: [[#@LINE+1]]:3: error: `[]` is applied to a `float`; only arrays, vectors, matrices and buffers have elements [not-indexable, X3121]
  v.x[0];
  // CHECK: [[#@LINE+1]]:5: error: operator `+` is applied to `float4` and `S`; the operands need a common type [operands-mismatch, X3020]
  v + s;
  // CHECK: [[#@LINE+1]]:5: error: operator `*` is applied to `float4` and `float4x4`; the operands need a common type [operands-mismatch, X3020]
  v * m;
  // CHECK: [[#@LINE+1]]:5: error: operator `&` is applied to `float4`; it needs `int` or `uint` [integer-needed, X3082]
  v & 1;
  // CHECK: [[#@LINE+1]]:3: error: operator `~` is applied to `float`; it needs `int` or `uint` [integer-needed, X3082]
  ~v.x;
  // CHECK: [[#@LINE+1]]:3: error: operator `-` is applied to a `S`; it needs numbers [bad-operand, X3022]
  -s;
  // CHECK: [[#@LINE+1]]:18: error: cannot convert `float3` to `float4` [cannot-convert, X3017]
  float4 wider = v.xyz;
  // CHECK: [[#@LINE+1]]:19: error: cannot cast `float3` to `float4` [cannot-cast, X3017]
  float4 widest = (float4)v.xyz;
  // CHECK: [[#@LINE+1]]:3: error: `float4` is made of 4 components; 3 given [wrong-component-count, X3014]
  float4(1, 2, 3);
  // CHECK: [[#@LINE+1]]:3: error: `S` has no constructor [not-constructible, X3037]
  S(1, 2);
  // CHECK: [[#@LINE+1]]:3: error: the sides of `?:` are `float4` and `S`; they need a common type [branches-differ, X3020]
  v.x > 0 ? v : s;
  // CHECK: [[#@LINE+1]]:9: error: cannot convert `Texture2D<float4>` to `SamplerState` [cannot-convert, X3017]
  s.s = one;
  name;
  // CHECK: [[#@LINE+1]]:13: error: cannot convert `void` to `float` [cannot-convert, X3017]
  float f = nothing();
  // CHECK: [[#@LINE+1]]:3: error: components are repeated; each can be assigned only once [swizzle-repeats, X3025]
  v.xx[int(v.x)] = 1;
  return v;
}
