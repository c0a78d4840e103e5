// An index of a ConstantBuffer array that is not constant, and one whose T is read from rows.
// RUN: %clipc -T vs_5_1 --target=glsl400 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_1 --target=vulkan --validate %s -o %t
// AUTOUPDATE
struct Object {
  float4 color;
};
struct Packed {
  float x;
  float3 y;
};
ConstantBuffer<Object> objects[3];
ConstantBuffer<Packed> packed[2];
ConstantBuffer<Packed> single;

float4 Read(Object o) { return o.color; }

float4 main(float4 p : POSITION, int i : INDEX) : SV_Position {
  return p + objects[i].color + Read(objects[i + 1]) + packed[i].y.xyzx + packed[1].x + single.y.xyzx;
}

// CHECK: #version 400
// CHECK-EMPTY:
// CHECK-NEXT: struct Packed {
// CHECK-NEXT:     float x;
// CHECK-NEXT:     vec3 y;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct Object {
// CHECK-NEXT:     vec4 color;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140) uniform objects_block {  // b0
// CHECK-NEXT:     vec4 color;
// CHECK-NEXT: } objects[3];
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140) uniform packed_block {  // b3
// CHECK-NEXT:     vec4 packed_rows[1];
// CHECK-NEXT: } packed_buffers[2];
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140) uniform single_block {  // b5
// CHECK-NEXT:     vec4 single_rows[1];
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-NEXT: layout(location = 1) in int in_INDEX0;  // i : INDEX0
// CHECK-EMPTY:
// CHECK-NEXT: Packed packed_(int i) {  // offset 0
// CHECK-NEXT:     return Packed(packed_buffers[i].packed_rows[0].x, packed_buffers[i].packed_rows[0].yzw);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: Packed single() {  // offset 0
// CHECK-NEXT:     return Packed(single_rows[0].x, single_rows[0].yzw);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: Object objects_value(int i) {
// CHECK-NEXT:     return Object(objects[i].color);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Read(Object o) {
// CHECK-NEXT:     return o.color;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = in_POSITION0 + objects[in_INDEX0].color + Read(objects_value(in_INDEX0 + 1)) + packed_(in_INDEX0).y.xyzx + packed_(1).x + single().y.xyzx;
// CHECK-NEXT: }
