// Inputs that the shader does not read are not declared. The others keep the locations that the signature gives them, so that one
// vertex layout fits every shader with that signature; --reflect lists all and says which are used.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --validate --target=vulkan %s -o - | FileCheck %s --check-prefix=VULKAN
// RUN: %clipc -T vs_5_0 --validate --target=glsl120 --lower=level9 %s -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T vs_5_0 --validate --target=glsl130 %s -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T vs_5_0 --reflect=%t.json %s -o %t.vert
// RUN: FileCheck %s --check-prefix=REFLECT --input-file %t.json
// RUN: %clipc -T vs_5_0 --variants --plane-space=object --position-input=REST0 %s -o %t.v.vert
// RUN: FileCheck %s --check-prefix=NONE --input-file %t.v.0.vert
// RUN: FileCheck %s --check-prefix=ONE --input-file %t.v.1.vert
// RUN: %draw compare %s -T vs_5_0 --lower clip-distance --target glsl450,glsl330,glsl130,essl300,vulkan
// RUN: %draw compare %s -T vs_5_0 --lower level9 --target glsl120
struct Vertex {
  float4 position : POSITION;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD;
};
struct Rest {
  float4 at : REST0;
  uint4 bones : BONES;
  uint id : SV_VertexID;
};
float4 plane;

float4 shade(float2 uv) { return uv.xyxy; }

[clipplanes(plane)]
void main(Vertex v, float2 unread : UNREAD, Rest rest, float fog : FOG, out float4 position : SV_Position, out float4 color : COLOR) {
  float4 spare = float4(v.normal, 1);
  position = v.position;
  color = shade(v.uv) * fog;
}

// CHECK: } globals;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // position : POSITION0
// CHECK-NEXT: layout(location = 2) in vec2 in_TEXCOORD0;  // uv : TEXCOORD0
// CHECK-NEXT: layout(location = 6) in float in_FOG0;  // fog : FOG0
// CHECK-EMPTY:
// CHECK: void main() {
// CHECK-NEXT: vec4 position = in_POSITION0;

// OLD: in_POSITION0;
// OLD-NOT: in_
// OLD: in_TEXCOORD0;
// OLD-NOT: in_
// OLD: in_FOG0;

// REFLECT: "semantic": "POSITION",
// REFLECT: "location": 0,
// REFLECT: "used": true
// REFLECT: "semantic": "NORMAL",
// REFLECT: "location": 1,
// REFLECT: "used": false
// REFLECT: "semantic": "TEXCOORD",
// REFLECT: "location": 2,
// REFLECT: "used": true
// REFLECT: "semantic": "UNREAD",
// REFLECT: "location": 3,
// REFLECT: "used": false
// REFLECT: "semantic": "REST",
// REFLECT: "location": 4,
// REFLECT: "used": false
// REFLECT: "semantic": "BONES",
// REFLECT: "location": 5,
// REFLECT: "used": false
// REFLECT: "semantic": "SV_VertexID",
// REFLECT: "used": false
// REFLECT: "semantic": "FOG",
// REFLECT: "location": 6,
// REFLECT: "used": true

// NONE-NOT: in_REST0
// ONE: layout(location = 4) in vec4 in_REST0;  // at : REST0
// ONE: gl_ClipDistance[0] = dot(in_REST0, globals.plane);

// VULKAN: layout(location = 2) in vec2 in_TEXCOORD0;
// VULKAN-NEXT: layout(location = 6) in float in_FOG0;
