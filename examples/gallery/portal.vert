#version 450

layout(std140, binding = 0) uniform view_block {  // b0
    layout(row_major) mat4 view_projection;
    vec4 edges[4];
    vec4 portal;
} view;

layout(std140, binding = 1) uniform Object {  // b1
    mat3x4 world;
} object;

layout(location = 0) in vec3 in_POSITION0;  // position : POSITION0
layout(location = 1) in vec4 in_COLOR0;  // color : COLOR0

layout(location = 0) out vec4 vs_COLOR0;  // out_color : COLOR0
// clip distances written: 0x1f
out float gl_ClipDistance[5];

void main() {
    vs_COLOR0 = in_COLOR0;
    vec3 world_position = vec4(in_POSITION0, 1.0) * object.world;
    vec4 result = view.view_projection * vec4(world_position, 1.0);
    gl_Position = result;
    gl_ClipDistance[0] = dot(result, view.edges[0]);
    gl_ClipDistance[1] = dot(result, view.edges[1]);
    gl_ClipDistance[2] = dot(result, view.edges[2]);
    gl_ClipDistance[3] = dot(result, view.edges[3]);
    gl_ClipDistance[4] = dot(result, view.portal);
}
