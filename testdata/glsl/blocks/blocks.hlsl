// The forms of a constant buffer: with an instance name whose matrices say how they lie, without one, and outside blocks.
// RUN: %clipc -T vs_5_1 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_1 --validate --blocks=plain %s -o - | FileCheck %s --check-prefix=PLAIN
// RUN: %clipc -T vs_5_1 --validate --blocks=flat %s -o - | FileCheck %s --check-prefix=FLAT
// RUN: %clipc -T vs_5_1 --validate --target=glsl330 --names=dxc %s -o - | FileCheck %s --check-prefix=DXC
// RUN: %clipc -T vs_5_1 --validate --target=glsl330 --names=spirv-cross %s -o - | FileCheck %s --check-prefix=CROSS
// RUN: %draw compare %s -T vs_5_1
// AUTOUPDATE
float fade;
cbuffer PerFrame : register(b1) {
  float4x4 view_projection;
  float4 lights[2];
  float texture;
  bool is_on;
}
cbuffer cbObject : register(b2) { row_major float4x4 world; };
cbuffer light : register(b3) { float4 color; };
struct Camera { float4x4 view; float4 eye; };
ConstantBuffer<Camera> camera : register(b4);
struct Vertex { float4 position : SV_Position; float4 tint : COLOR; float2 uv : TEXCOORD1; };

// The members of a block hide no local variable or function.
float4 eye(float4 perFrame) { return perFrame * texture; }

Vertex main(float4 p : POSITION) {
  Vertex vertex;
  float4 moved = mul(mul(p, world), view_projection);
  vertex.position = moved * fade + eye(camera.eye);
  vertex.tint = lights[1] + color + mul(p, camera.view);
  vertex.uv = 1;
  if (is_on) vertex.uv = 2;
  return vertex;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// CHECK-NEXT:     float fade;
// CHECK-NEXT: } globals;
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 1) uniform PerFrame {  // b1
// CHECK-NEXT:     layout(row_major) mat4 view_projection;
// CHECK-NEXT:     vec4 lights[2];
// CHECK-NEXT:     float texture;
// CHECK-NEXT:     uint is_on;
// CHECK-NEXT: } perFrame;
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 2) uniform cbObject {  // b2
// CHECK-NEXT:     mat4 world;
// CHECK-NEXT: } object;
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 3) uniform light {  // b3
// CHECK-NEXT:     vec4 color;
// CHECK-NEXT: } light_data;
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 4) uniform camera_block {  // b4
// CHECK-NEXT:     layout(row_major) mat4 view;
// CHECK-NEXT:     vec4 eye;
// CHECK-NEXT: } camera;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) out vec4 vs_COLOR0;  // tint : COLOR0
// CHECK-NEXT: layout(location = 1) out vec2 vs_TEXCOORD1;  // uv : TEXCOORD1
// CHECK-EMPTY:
// CHECK-NEXT: vec4 eye(vec4 perFrame_2) {
// CHECK-NEXT:     return perFrame_2 * perFrame.texture;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec4 moved = perFrame.view_projection * (object.world * in_POSITION0);
// CHECK-NEXT:     gl_Position = moved * globals.fade + eye(camera.eye);
// CHECK-NEXT:     vs_COLOR0 = perFrame.lights[1] + light_data.color + camera.view * in_POSITION0;
// CHECK-NEXT:     vs_TEXCOORD1 = vec2(1.0);
// CHECK-NEXT:     if (bool(perFrame.is_on)) {
// CHECK-NEXT:         vs_TEXCOORD1 = vec2(2.0);
// CHECK-NEXT:     }
// CHECK-NEXT: }

// PLAIN: #version 450
// PLAIN-EMPTY:
// PLAIN-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// PLAIN-NEXT:     float fade;
// PLAIN-NEXT: };
// PLAIN-EMPTY:
// PLAIN-NEXT: layout(std140, binding = 1, row_major) uniform PerFrame {  // b1
// PLAIN-NEXT:     mat4 view_projection;
// PLAIN-NEXT:     vec4 lights[2];
// PLAIN-NEXT:     float texture_;
// PLAIN-NEXT:     bool is_on;
// PLAIN-NEXT: };
// PLAIN-EMPTY:
// PLAIN-NEXT: layout(std140, binding = 2) uniform cbObject {  // b2
// PLAIN-NEXT:     mat4 world;
// PLAIN-NEXT: };
// PLAIN-EMPTY:
// PLAIN-NEXT: layout(std140, binding = 3) uniform light {  // b3
// PLAIN-NEXT:     vec4 color;
// PLAIN-NEXT: };
// PLAIN-EMPTY:
// PLAIN-NEXT: layout(std140, binding = 4, row_major) uniform camera_block {  // b4
// PLAIN-NEXT:     mat4 view;
// PLAIN-NEXT:     vec4 eye;
// PLAIN-NEXT: } camera;
// PLAIN-EMPTY:
// PLAIN-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// PLAIN-EMPTY:
// PLAIN-NEXT: layout(location = 0) out vec4 vs_COLOR0;  // tint : COLOR0
// PLAIN-NEXT: layout(location = 1) out vec2 vs_TEXCOORD1;  // uv : TEXCOORD1
// PLAIN-EMPTY:
// PLAIN-NEXT: vec4 eye(vec4 perFrame) {
// PLAIN-NEXT:     return perFrame * texture_;
// PLAIN-NEXT: }
// PLAIN-EMPTY:
// PLAIN-NEXT: void main() {
// PLAIN-NEXT:     vec4 moved = view_projection * (world * in_POSITION0);
// PLAIN-NEXT:     gl_Position = moved * fade + eye(camera.eye);
// PLAIN-NEXT:     vs_COLOR0 = lights[1] + color + camera.view * in_POSITION0;
// PLAIN-NEXT:     vs_TEXCOORD1 = vec2(1.0);
// PLAIN-NEXT:     if (is_on) {
// PLAIN-NEXT:         vs_TEXCOORD1 = vec2(2.0);
// PLAIN-NEXT:     }
// PLAIN-NEXT: }

// FLAT: #version 450
// FLAT-EMPTY:
// FLAT-NEXT: struct Camera {
// FLAT-NEXT:     mat4 view;
// FLAT-NEXT:     vec4 eye;
// FLAT-NEXT: };
// FLAT-EMPTY:
// FLAT-NEXT: // $Globals, b0
// FLAT-NEXT: uniform float fade;
// FLAT-EMPTY:
// FLAT-NEXT: // PerFrame, b1
// FLAT-NEXT: uniform mat4 view_projection;
// FLAT-NEXT: uniform vec4 lights[2];
// FLAT-NEXT: uniform float texture_;
// FLAT-NEXT: uniform bool is_on;
// FLAT-EMPTY:
// FLAT-NEXT: // cbObject, b2
// FLAT-NEXT: uniform mat4 world;
// FLAT-EMPTY:
// FLAT-NEXT: // light, b3
// FLAT-NEXT: uniform vec4 color;
// FLAT-EMPTY:
// FLAT-NEXT: // camera, b4
// FLAT-NEXT: uniform Camera camera;
// FLAT-EMPTY:
// FLAT-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// FLAT-EMPTY:
// FLAT-NEXT: layout(location = 0) out vec4 vs_COLOR0;  // tint : COLOR0
// FLAT-NEXT: layout(location = 1) out vec2 vs_TEXCOORD1;  // uv : TEXCOORD1
// FLAT-EMPTY:
// FLAT-NEXT: vec4 eye(vec4 perFrame) {
// FLAT-NEXT:     return perFrame * texture_;
// FLAT-NEXT: }
// FLAT-EMPTY:
// FLAT-NEXT: void main() {
// FLAT-NEXT:     vec4 moved = view_projection * (world * in_POSITION0);
// FLAT-NEXT:     gl_Position = moved * fade + eye(camera.eye);
// FLAT-NEXT:     vs_COLOR0 = lights[1] + color + camera.view * in_POSITION0;
// FLAT-NEXT:     vs_TEXCOORD1 = vec2(1.0);
// FLAT-NEXT:     if (is_on) {
// FLAT-NEXT:         vs_TEXCOORD1 = vec2(2.0);
// FLAT-NEXT:     }
// FLAT-NEXT: }

// DXC: #version 330
// DXC-EMPTY:
// DXC-NEXT: layout(std140) uniform type_Globals {  // b0
// DXC-NEXT:     float fade;
// DXC-NEXT: } globals;
// DXC-EMPTY:
// DXC-NEXT: layout(std140) uniform type_PerFrame {  // b1
// DXC-NEXT:     layout(row_major) mat4 view_projection;
// DXC-NEXT:     vec4 lights[2];
// DXC-NEXT:     float texture;
// DXC-NEXT:     uint is_on;
// DXC-NEXT: } perFrame;
// DXC-EMPTY:
// DXC-NEXT: layout(std140) uniform type_cbObject {  // b2
// DXC-NEXT:     mat4 world;
// DXC-NEXT: } object;
// DXC-EMPTY:
// DXC-NEXT: layout(std140) uniform type_light {  // b3
// DXC-NEXT:     vec4 color;
// DXC-NEXT: } light_data;
// DXC-EMPTY:
// DXC-NEXT: layout(std140) uniform type_ConstantBuffer_Camera {  // b4
// DXC-NEXT:     layout(row_major) mat4 view;
// DXC-NEXT:     vec4 eye;
// DXC-NEXT: } camera;
// DXC-EMPTY:
// DXC-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// DXC-EMPTY:
// DXC-NEXT: out vec4 in_var_COLOR;  // tint : COLOR0
// DXC-NEXT: out vec2 in_var_TEXCOORD1;  // uv : TEXCOORD1
// DXC-EMPTY:
// DXC-NEXT: vec4 eye(vec4 perFrame_2) {
// DXC-NEXT:     return perFrame_2 * perFrame.texture;
// DXC-NEXT: }
// DXC-EMPTY:
// DXC-NEXT: void main() {
// DXC-NEXT:     vec4 moved = perFrame.view_projection * (object.world * in_POSITION0);
// DXC-NEXT:     gl_Position = moved * globals.fade + eye(camera.eye);
// DXC-NEXT:     in_var_COLOR = perFrame.lights[1] + light_data.color + camera.view * in_POSITION0;
// DXC-NEXT:     in_var_TEXCOORD1 = vec2(1.0);
// DXC-NEXT:     if (bool(perFrame.is_on)) {
// DXC-NEXT:         in_var_TEXCOORD1 = vec2(2.0);
// DXC-NEXT:     }
// DXC-NEXT: }

// CROSS: #version 330
// CROSS-EMPTY:
// CROSS-NEXT: layout(std140) uniform _Global {  // b0
// CROSS-NEXT:     float fade;
// CROSS-NEXT: } globals;
// CROSS-EMPTY:
// CROSS-NEXT: layout(std140) uniform PerFrame {  // b1
// CROSS-NEXT:     layout(row_major) mat4 view_projection;
// CROSS-NEXT:     vec4 lights[2];
// CROSS-NEXT:     float texture;
// CROSS-NEXT:     uint is_on;
// CROSS-NEXT: } perFrame;
// CROSS-EMPTY:
// CROSS-NEXT: layout(std140) uniform cbObject {  // b2
// CROSS-NEXT:     mat4 world;
// CROSS-NEXT: } object;
// CROSS-EMPTY:
// CROSS-NEXT: layout(std140) uniform light {  // b3
// CROSS-NEXT:     vec4 color;
// CROSS-NEXT: } light_data;
// CROSS-EMPTY:
// CROSS-NEXT: layout(std140) uniform camera {  // b4
// CROSS-NEXT:     layout(row_major) mat4 view;
// CROSS-NEXT:     vec4 eye;
// CROSS-NEXT: } camera_2;
// CROSS-EMPTY:
// CROSS-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CROSS-EMPTY:
// CROSS-NEXT: out vec4 input_tint;  // tint : COLOR0
// CROSS-NEXT: out vec2 input_uv;  // uv : TEXCOORD1
// CROSS-EMPTY:
// CROSS-NEXT: vec4 eye(vec4 perFrame_2) {
// CROSS-NEXT:     return perFrame_2 * perFrame.texture;
// CROSS-NEXT: }
// CROSS-EMPTY:
// CROSS-NEXT: void main() {
// CROSS-NEXT:     vec4 moved = perFrame.view_projection * (object.world * in_POSITION0);
// CROSS-NEXT:     gl_Position = moved * globals.fade + eye(camera_2.eye);
// CROSS-NEXT:     input_tint = perFrame.lights[1] + light_data.color + camera_2.view * in_POSITION0;
// CROSS-NEXT:     input_uv = vec2(1.0);
// CROSS-NEXT:     if (bool(perFrame.is_on)) {
// CROSS-NEXT:         input_uv = vec2(2.0);
// CROSS-NEXT:     }
// CROSS-NEXT: }
