#version 450

layout(triangles, invocations = 6) in;
layout(triangle_strip, max_vertices = 3) out;

struct Corner {
    vec4 position;
    vec3 normal;
    vec2 uv;
    uint face;
};

layout(std140, binding = 0) uniform Faces {  // b0
    layout(row_major) mat4 view_projection[6];
} faces;

layout(location = 0) in vec3 vs_NORMAL0[];  // normal : NORMAL0
layout(location = 1) in vec2 vs_TEXCOORD0[];  // uv : TEXCOORD0

layout(location = 0) out vec3 gs_NORMAL0;  // normal : NORMAL0
layout(location = 1) out vec2 gs_TEXCOORD0;  // uv : TEXCOORD0

void append_stream(Corner vertex) {
    uint gs_SV_RENDERTARGETARRAYINDEX0;
    gl_Position = vertex.position;
    gs_NORMAL0 = vertex.normal;
    gs_TEXCOORD0 = vertex.uv;
    gs_SV_RENDERTARGETARRAYINDEX0 = vertex.face;
    gl_Layer = int(gs_SV_RENDERTARGETARRAYINDEX0);
    EmitVertex();
}

void main() {
    uint face = uint(gl_InvocationID);
    for (int i = 0; i < 3; ++i) {
        Corner corner;
        corner.position = faces.view_projection[face] * gl_in[i].gl_Position;
        corner.normal = vs_NORMAL0[i];
        corner.uv = vs_TEXCOORD0[i];
        corner.face = face;
        append_stream(corner);
    }
}
