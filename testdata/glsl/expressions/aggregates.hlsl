// Structs and arrays: constructors, zeros, copies. Arrays of arrays are wrapped where GLSL has none.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl330 --validate %s -o - | FileCheck %s --check-prefix=WRAPPED
// RUN: %clipc -T vs_5_0 --target=glsl120 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o %t
// AUTOUPDATE
struct Inner {
  float2 a[2];
  bool b;
};
struct Outer {
  Inner inner;
  float table[2][3];
};
struct Empty {};
static const float kWeights[3] = { 0.25, 0.5, 0.25 };
static const float kTable[2][2] = { { 1, 2 }, { 3, 4 } };
float uniforms[2][3];

Outer Make() {
  Outer outer = (Outer)0;
  outer.inner.a[1] = 2;
  return outer;
}
void Take(Empty empty) {}
void Fill(out float row[3]) { row[0] = row[1] = row[2] = 1; }

float4 main(float4 p : POSITION, int i : INDEX) : SV_Position {
  Inner inner = { { p.xy, p.zw }, true };
  Outer outer = { inner, { { 1, 2, 3 }, { 4, 5, 6 } } };
  Outer other = Make();
  other.inner = outer.inner;
  Fill(other.table[1]);
  float row[3] = other.table[i];
  float zeros[20] = (float[20])0;
  Empty empty;
  Take(empty);
  float2 grid[2][2];
  grid[1][i] = p.xy;
  return p * kWeights[i] + kTable[1][i] + uniforms[1][i] + outer.inner.a[i].xyxy + row[2] + other.table[1][i] + zeros[i] + grid[1][0].x;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: struct Inner {
// CHECK-NEXT:     vec2 a[2];
// CHECK-NEXT:     bool b;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct Outer {
// CHECK-NEXT:     Inner inner;
// CHECK-NEXT:     float table[2][3];
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct Empty {
// CHECK-NEXT:     float empty;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// CHECK-NEXT:     float uniforms[2][3];
// CHECK-NEXT: } globals;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-NEXT: layout(location = 1) in int in_INDEX0;  // i : INDEX0
// CHECK-EMPTY:
// CHECK-NEXT: float[20] zeros_float_20_() {
// CHECK-NEXT:     float result[20];
// CHECK-NEXT:     for (int i = 0; i < 20; ++i) result[i] = 0.0;
// CHECK-NEXT:     return result;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: const float kWeights[3] = float[3](0.25, 0.5, 0.25);
// CHECK-NEXT: const float kTable[2][2] = float[2][2](float[2](1.0, 2.0), float[2](3.0, 4.0));
// CHECK-EMPTY:
// CHECK-NEXT: Outer Make() {
// CHECK-NEXT:     Outer outer = Outer(Inner(vec2[2](vec2(0.0), vec2(0.0)), false), float[2][3](float[3](0.0, 0.0, 0.0), float[3](0.0, 0.0, 0.0)));
// CHECK-NEXT:     outer.inner.a[1] = vec2(2.0);
// CHECK-NEXT:     return outer;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void Fill(out float row[3]) {
// CHECK-NEXT:     row[0] = row[1] = row[2] = 1.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void Take(Empty empty) {
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     Inner inner = Inner(vec2[2](in_POSITION0.xy, in_POSITION0.zw), true);
// CHECK-NEXT:     Outer outer = Outer(inner, float[2][3](float[3](1.0, 2.0, 3.0), float[3](4.0, 5.0, 6.0)));
// CHECK-NEXT:     Outer other = Make();
// CHECK-NEXT:     other.inner = outer.inner;
// CHECK-NEXT:     Fill(other.table[1]);
// CHECK-NEXT:     float row[3] = other.table[in_INDEX0];
// CHECK-NEXT:     float zeros[20] = zeros_float_20_();
// CHECK-NEXT:     Empty empty;
// CHECK-NEXT:     Take(empty);
// CHECK-NEXT:     vec2 grid[2][2];
// CHECK-NEXT:     grid[1][in_INDEX0] = in_POSITION0.xy;
// CHECK-NEXT:     gl_Position = in_POSITION0 * kWeights[in_INDEX0] + kTable[1][in_INDEX0] + globals.uniforms[1][in_INDEX0] + outer.inner.a[in_INDEX0].xyxy + row[2] + other.table[1][in_INDEX0] + zeros[in_INDEX0] + grid[1][0].x;
// CHECK-NEXT: }

// WRAPPED: #version 330
// WRAPPED-EMPTY:
// WRAPPED-NEXT: struct float_array3 {
// WRAPPED-NEXT:     float e[3];
// WRAPPED-NEXT: };
// WRAPPED-EMPTY:
// WRAPPED-NEXT: struct float_array2 {
// WRAPPED-NEXT:     float e[2];
// WRAPPED-NEXT: };
// WRAPPED-EMPTY:
// WRAPPED-NEXT: struct Inner {
// WRAPPED-NEXT:     vec2 a[2];
// WRAPPED-NEXT:     bool b;
// WRAPPED-NEXT: };
// WRAPPED-EMPTY:
// WRAPPED-NEXT: struct Outer {
// WRAPPED-NEXT:     Inner inner;
// WRAPPED-NEXT:     float_array3 table[2];
// WRAPPED-NEXT: };
// WRAPPED-EMPTY:
// WRAPPED-NEXT: struct Empty {
// WRAPPED-NEXT:     float empty;
// WRAPPED-NEXT: };
// WRAPPED-EMPTY:
// WRAPPED-NEXT: struct vec2_array2 {
// WRAPPED-NEXT:     vec2 e[2];
// WRAPPED-NEXT: };
// WRAPPED-EMPTY:
// WRAPPED-NEXT: layout(std140) uniform Globals {  // b0
// WRAPPED-NEXT:     float_array3 uniforms[2];
// WRAPPED-NEXT: } globals;
// WRAPPED-EMPTY:
// WRAPPED-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// WRAPPED-NEXT: layout(location = 1) in int in_INDEX0;  // i : INDEX0
// WRAPPED-EMPTY:
// WRAPPED-NEXT: float[20] zeros_float_20_() {
// WRAPPED-NEXT:     float result[20];
// WRAPPED-NEXT:     for (int i = 0; i < 20; ++i) result[i] = 0.0;
// WRAPPED-NEXT:     return result;
// WRAPPED-NEXT: }
// WRAPPED-EMPTY:
// WRAPPED-NEXT: const float kWeights[3] = float[3](0.25, 0.5, 0.25);
// WRAPPED-NEXT: const float_array2 kTable[2] = float_array2[2](float_array2(float[2](1.0, 2.0)), float_array2(float[2](3.0, 4.0)));
// WRAPPED-EMPTY:
// WRAPPED-NEXT: Outer Make() {
// WRAPPED-NEXT:     Outer outer = Outer(Inner(vec2[2](vec2(0.0), vec2(0.0)), false), float_array3[2](float_array3(float[3](0.0, 0.0, 0.0)), float_array3(float[3](0.0, 0.0, 0.0))));
// WRAPPED-NEXT:     outer.inner.a[1] = vec2(2.0);
// WRAPPED-NEXT:     return outer;
// WRAPPED-NEXT: }
// WRAPPED-EMPTY:
// WRAPPED-NEXT: void Fill(out float row[3]) {
// WRAPPED-NEXT:     row[0] = row[1] = row[2] = 1.0;
// WRAPPED-NEXT: }
// WRAPPED-EMPTY:
// WRAPPED-NEXT: void Take(Empty empty) {
// WRAPPED-NEXT: }
// WRAPPED-EMPTY:
// WRAPPED-NEXT: void main() {
// WRAPPED-NEXT:     Inner inner = Inner(vec2[2](in_POSITION0.xy, in_POSITION0.zw), true);
// WRAPPED-NEXT:     Outer outer = Outer(inner, float_array3[2](float_array3(float[3](1.0, 2.0, 3.0)), float_array3(float[3](4.0, 5.0, 6.0))));
// WRAPPED-NEXT:     Outer other = Make();
// WRAPPED-NEXT:     other.inner = outer.inner;
// WRAPPED-NEXT:     Fill(other.table[1].e);
// WRAPPED-NEXT:     float row[3] = other.table[in_INDEX0].e;
// WRAPPED-NEXT:     float zeros[20] = zeros_float_20_();
// WRAPPED-NEXT:     Empty empty;
// WRAPPED-NEXT:     Take(empty);
// WRAPPED-NEXT:     vec2_array2 grid[2];
// WRAPPED-NEXT:     grid[1].e[in_INDEX0] = in_POSITION0.xy;
// WRAPPED-NEXT:     gl_Position = in_POSITION0 * kWeights[in_INDEX0] + kTable[1].e[in_INDEX0] + globals.uniforms[1].e[in_INDEX0] + outer.inner.a[in_INDEX0].xyxy + row[2] + other.table[1].e[in_INDEX0] + zeros[in_INDEX0] + grid[1].e[0].x;
// WRAPPED-NEXT: }
