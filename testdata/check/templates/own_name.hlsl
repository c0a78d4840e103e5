// Inside a struct template its name is known, with arguments and, for this instance, without. A static method is one function
// for all that derive from its struct.
// RUN: %clipc -T vs_6_6 --target=glsl450 --validate %s -o - | FileCheck %s
// AUTOUPDATE
template<typename T, int N> struct Stack {
  T items[N];
  Stack<T, N> Copy() { return this; }
  Stack Same() { Stack<T, N> same = this; return same; }
};
struct Base { static float Two() { return 2; } };
struct Derived : Base { float value; };
float4 main(float4 p : POSITION) : SV_Position {
  Stack<float, 2> stack = {p.x, p.y};
  return p * stack.Copy().Same().items[1] * Derived::Two() * Base::Two();
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: struct Stack {
// CHECK-NEXT:     float items[2];
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: Stack Same(Stack self) {
// CHECK-NEXT:     Stack same = self;
// CHECK-NEXT:     return same;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: Stack Copy(Stack self) {
// CHECK-NEXT:     return self;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float Two() {
// CHECK-NEXT:     return 2.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     Stack stack = Stack(float[2](in_POSITION0.x, in_POSITION0.y));
// CHECK-NEXT:     gl_Position = in_POSITION0 * Same(Copy(stack)).items[1] * Two() * Two();
// CHECK-NEXT: }
