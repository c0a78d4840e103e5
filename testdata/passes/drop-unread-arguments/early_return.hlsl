// An entry function that returns early stays a function; it gets zeros for the inputs that it does not read.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --validate -E whole %s -o - | FileCheck %s --check-prefix=WHOLE
// RUN: %draw compare -T vs_5_0 %s
// RUN: %draw compare -T vs_5_0 -E whole %s
// RUN: %draw compare -T vs_5_0 -E changed %s
// AUTOUPDATE
float4x4 view_projection;
bool is_on;
struct Vertex {
  float4 position : POSITION;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD;
};
float4 place(Vertex v) { return v.position + v.normal.xyzz; }

float4 main(Vertex v, float4 unread : UNREAD, float2 read : READ, out float4 color : COLOR) : SV_Position {
  color = v.uv.xyxy;
  if (is_on) return v.position;
  return mul(v.position, view_projection) + read.xyxy;
}

float4 whole(Vertex v, float4 unread : UNREAD) : SV_Position {
  if (is_on) return 1;
  return place(v);
}

float4 changed(Vertex v) : SV_Position {
  v.normal = 1;
  if (is_on) return v.position;
  return place(v);
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: struct Vertex {
// CHECK-NEXT:     vec4 position;
// CHECK-NEXT:     vec3 normal;
// CHECK-NEXT:     vec2 uv;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// CHECK-NEXT:     layout(row_major) mat4 view_projection;
// CHECK-NEXT:     uint is_on;
// CHECK-NEXT: } globals;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // position : POSITION0
// CHECK-NEXT: layout(location = 2) in vec2 in_TEXCOORD0;  // uv : TEXCOORD0
// CHECK-NEXT: layout(location = 4) in vec2 in_READ0;  // read : READ0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) out vec4 vs_COLOR0;  // color : COLOR0
// CHECK-EMPTY:
// CHECK-NEXT: vec4 shader_main(Vertex v, vec4 unread, vec2 read, out vec4 color) {
// CHECK-NEXT:     color = v.uv.xyxy;
// CHECK-NEXT:     if (bool(globals.is_on)) {
// CHECK-NEXT:         return v.position;
// CHECK-NEXT:     }
// CHECK-NEXT:     return globals.view_projection * v.position + read.xyxy;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     Vertex v = Vertex(in_POSITION0, vec3(0.0), in_TEXCOORD0);
// CHECK-NEXT:     gl_Position = shader_main(v, vec4(0.0), in_READ0, vs_COLOR0);
// CHECK-NEXT: }

// WHOLE: #version 450
// WHOLE-EMPTY:
// WHOLE-NEXT: struct Vertex {
// WHOLE-NEXT:     vec4 position;
// WHOLE-NEXT:     vec3 normal;
// WHOLE-NEXT:     vec2 uv;
// WHOLE-NEXT: };
// WHOLE-EMPTY:
// WHOLE-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// WHOLE-NEXT:     layout(row_major) mat4 view_projection;
// WHOLE-NEXT:     uint is_on;
// WHOLE-NEXT: } globals;
// WHOLE-EMPTY:
// WHOLE-NEXT: layout(location = 0) in vec4 in_POSITION0;  // position : POSITION0
// WHOLE-NEXT: layout(location = 1) in vec3 in_NORMAL0;  // normal : NORMAL0
// WHOLE-NEXT: layout(location = 2) in vec2 in_TEXCOORD0;  // uv : TEXCOORD0
// WHOLE-EMPTY:
// WHOLE-NEXT: vec4 place(Vertex v) {
// WHOLE-NEXT:     return v.position + v.normal.xyzz;
// WHOLE-NEXT: }
// WHOLE-EMPTY:
// WHOLE-NEXT: vec4 whole(Vertex v, vec4 unread) {
// WHOLE-NEXT:     if (bool(globals.is_on)) {
// WHOLE-NEXT:         return vec4(1.0);
// WHOLE-NEXT:     }
// WHOLE-NEXT:     return place(v);
// WHOLE-NEXT: }
// WHOLE-EMPTY:
// WHOLE-NEXT: void main() {
// WHOLE-NEXT:     Vertex v = Vertex(in_POSITION0, in_NORMAL0, in_TEXCOORD0);
// WHOLE-NEXT:     gl_Position = whole(v, vec4(0.0));
// WHOLE-NEXT: }
