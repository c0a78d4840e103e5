#version 450

layout(triangles) in;
layout(triangle_strip, max_vertices = 9) out;

struct Corner {
    vec4 position;
    float along;
};

layout(std140, binding = 0) uniform Frame {  // b0
    layout(row_major) mat4 view_projection;
    vec4 water_plane;
    vec3 wind;
    float length_;
} frame;

layout(location = 0) in vec3 vs_POSITION0[];  // position : POSITION0
layout(location = 1) in vec3 vs_NORMAL0[];  // normal : NORMAL0

layout(location = 0) out float gs_TEXCOORD0;  // along : TEXCOORD0
// clip distances written: 0x1
out float gl_ClipDistance[1];

const int PARTS = 4;

void append_hair(Corner vertex) {
    gl_Position = vertex.position;
    gs_TEXCOORD0 = vertex.along;
    gl_ClipDistance[0] = dot(vertex.position, frame.water_plane);
    EmitVertex();
}

void main() {
    vec3 root = (vs_POSITION0[0] + vs_POSITION0[1] + vs_POSITION0[2]) / 3.0;
    vec3 up = normalize(vs_NORMAL0[0] + vs_NORMAL0[1] + vs_NORMAL0[2]);
    vec3 side = 0.1 * (vs_POSITION0[1] - vs_POSITION0[0]);
    Corner corner;
    for (int i = 0; i <= PARTS; ++i) {
        corner.along = float(i) / float(PARTS);
        vec3 at = root + frame.length_ * (up * corner.along + frame.wind * corner.along * corner.along);
        vec3 half_width = side * (1.0 - corner.along);
        if (i < PARTS) {
            corner.position = frame.view_projection * vec4(at - half_width, 1.0);
            append_hair(corner);
        }
        corner.position = frame.view_projection * vec4(at + half_width, 1.0);
        append_hair(corner);
    }
}
