#version 450

layout(std140, binding = 0) uniform Camera {  // b0
    layout(row_major) mat4 view_projection;
    vec3 eye;
    float time;
} camera;

layout(std140, binding = 1) uniform Object {  // b1
    layout(row_major) mat4 world;
    vec4 tint;
} object;

layout(std140, binding = 2) uniform Clip {  // b2
    vec4 water_plane;
} clip;

layout(location = 0) in vec3 in_POSITION0;  // position : POSITION0
layout(location = 1) in vec3 in_NORMAL0;  // normal : NORMAL0
layout(location = 2) in vec2 in_TEXCOORD0;  // uv : TEXCOORD0

layout(location = 0) out vec3 vs_NORMAL0;  // normal : NORMAL0
layout(location = 1) out vec3 vs_TEXCOORD1;  // to_eye : TEXCOORD1
layout(location = 2) out vec2 vs_TEXCOORD0;  // uv : TEXCOORD0
// clip distances written: 0x1
out float gl_ClipDistance[1];

void main() {
    vec4 world_position = object.world * vec4(in_POSITION0, 1.0);
    world_position.y = -world_position.y;
    vec4 position = camera.view_projection * world_position;
    vs_NORMAL0 = normalize(mat3(object.world) * in_NORMAL0) * vec3(1.0, -1.0, 1.0);
    vs_TEXCOORD1 = camera.eye - world_position.xyz;
    vs_TEXCOORD0 = in_TEXCOORD0 + vec2(0.02 * sin(camera.time), 0.0);
    gl_Position = position;
    gl_ClipDistance[0] = dot(position, clip.water_plane);
}
