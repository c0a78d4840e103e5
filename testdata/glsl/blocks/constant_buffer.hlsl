// ConstantBuffer<T> is a block with an instance name; before GLSL 1.50 a block of one struct.
// RUN: %clipc -T vs_5_1 --target=glsl450 --validate %s -o - | FileCheck %s --check-prefix=CHECK
// RUN: %clipc -T vs_5_1 --target=glsl140 --validate -DONE %s -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T vs_5_1 --target=glsl330 --validate %s -o %t
// RUN: %clipc -T vs_5_1 --target=essl300 --validate %s -o %t
// RUN: %clipc -T vs_5_1 --target=glsl120 --validate %s -o %t
// AUTOUPDATE
struct Object {
  float4x4 world;
  float4 color;
};
ConstantBuffer<Object> object : register(b1);
ConstantBuffer<Object> objects[3] : register(b2);

float4 Tint(Object o) { return o.color * 2; }

float4 main(float4 p : POSITION) : SV_Position {
  float4 r = mul(p, object.world) + object.color + Tint(object);
#ifndef ONE
  r += objects[1].color + Tint(objects[2]);
#endif
  return r;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: struct Object {
// CHECK-NEXT:     mat4 world;
// CHECK-NEXT:     vec4 color;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 1) uniform object_block {  // b1
// CHECK-NEXT:     layout(row_major) mat4 world;
// CHECK-NEXT:     vec4 color;
// CHECK-NEXT: } object;
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 2) uniform objects_block {  // b2
// CHECK-NEXT:     layout(row_major) mat4 world;
// CHECK-NEXT:     vec4 color;
// CHECK-NEXT: } objects[3];
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: Object object_value() {
// CHECK-NEXT:     return Object(object.world, object.color);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Tint(Object o) {
// CHECK-NEXT:     return o.color * 2.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = object.world * in_POSITION0 + object.color + Tint(object_value());
// CHECK-NEXT:     gl_Position += objects[1].color + Tint(Object(objects[2].world, objects[2].color));
// CHECK-NEXT: }

// OLD: #version 140
// OLD-EMPTY:
// OLD-NEXT: struct Object {
// OLD-NEXT:     mat4 world;
// OLD-NEXT:     vec4 color;
// OLD-NEXT: };
// OLD-EMPTY:
// OLD-NEXT: layout(std140) uniform object_block {  // b1
// OLD-NEXT:     layout(row_major) Object object;
// OLD-NEXT: };
// OLD-EMPTY:
// OLD-NEXT: in vec4 in_POSITION0;  // p : POSITION0
// OLD-EMPTY:
// OLD-NEXT: vec4 Tint(Object o) {
// OLD-NEXT:     return o.color * 2.0;
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: void main() {
// OLD-NEXT:     gl_Position = object.world * in_POSITION0 + object.color + Tint(object);
// OLD-NEXT: }
