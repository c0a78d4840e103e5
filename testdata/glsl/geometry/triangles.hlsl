// A triangle in, two triangles out, to layers that the shader chooses: each Append writes all outputs.
// RUN: %clipc %s -T gs_5_0 --depth-range=negative-one-to-one --validate -o - | FileCheck %s --check-prefixes=CHECK,GL
// RUN: %clipc %s -T gs_4_0 --target=glsl150 --validate -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc %s -T gs_5_0 --target=essl310 --validate -o - | FileCheck %s --check-prefix=ES
// RUN: %clipc %s -T gs_5_0 --target=essl320 --validate -o %t.es && %validate -S geom %t.es
// RUN: %clipc %s -T gs_6_0 --target=vulkan --validate -o - | FileCheck %s --check-prefixes=CHECK,VK
// RUN: %clipc %s -T gs_5_0 --target=vulkan --flip-y --validate -o - | FileCheck %s --check-prefix=FLIP
// RUN: %clipc %s -T gs_5_1 -spirv -fspv-target-env=vulkan1.0 -o %t.spv
// RUN: %draw compare %s -T gs_5_0
struct Vertex {
  float4 position : SV_Position;
  float2 uv : TEXCOORD0;
  float3 normal : NORMAL;
};
struct Corner {
  float4 position : SV_Position;
  float2 uv : TEXCOORD0;
  nointerpolation uint triangle_id : ID;
  uint layer : SV_RenderTargetArrayIndex;
};
cbuffer Frame {
  float4x4 faces[2];
  float height;
};

// OLD: #version 150
// ES: #version 310 es
// ES-NEXT: #extension GL_EXT_geometry_shader : require
// CHECK: layout(triangles) in;
// CHECK-NEXT: layout(triangle_strip, max_vertices = 6) out;
// CHECK: layout(location = 0) in vec2 vs_TEXCOORD0[];
// CHECK: layout(location = 1) in vec3 vs_NORMAL0[];
// OLD: in vec2 vs_TEXCOORD0[];
// ES: in vec2 vs_TEXCOORD0[];
// CHECK: layout(location = 0) out vec2 gs_TEXCOORD0;
// CHECK: layout(location = 1) flat out uint gs_ID0;
// CHECK: void append_stream(Corner vertex) {
// CHECK: gl_Position = vertex.position;
// GL: gl_Position.z = 2.0 * gl_Position.z - gl_Position.w;
// VK-NOT: gl_Position.z =
// FLIP: gl_Position.y = -gl_Position.y;
// CHECK: gl_Layer = int(
// CHECK-NEXT: EmitVertex();
// CHECK: gl_in[i].gl_Position + vec4(vs_NORMAL0[i]
// CHECK: EndPrimitive();
[maxvertexcount(6)]
void main(triangle Vertex corners[3], uint id : SV_PrimitiveID, inout TriangleStream<Corner> stream) {
  for (uint layer = 0; layer < 2; ++layer) {
    Corner corner;
    for (int i = 0; i < 3; ++i) {
      corner.position =
          mul(faces[layer], corners[i].position + float4(corners[i].normal * height, 0));
      corner.uv = corners[i].uv;
      corner.triangle_id = id;
      corner.layer = layer;
      stream.Append(corner);
    }
    stream.RestartStrip();
  }
}
