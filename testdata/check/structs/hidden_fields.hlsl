// A field that hides one of a base is another field: it lies after it, and has a name of its own in GLSL.
// RUN: %clipc -T vs_5_0 %s --validate | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,essl300,vulkan
struct Base { float4 x; };
// CHECK: struct Derived {
// CHECK-NEXT: vec4 x;
// CHECK-NEXT: vec4 x_2;
struct Derived : Base { float4 x; };
Derived given;
float4 main(float4 a : A) : SV_Position {
  Derived made;
  made.x = a;
  ((Base)made).x;
  // CHECK: gl_Position = made.x_2 + globals.given.x_2;
  return made.x + given.x;
}
