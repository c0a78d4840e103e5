#version 450
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Written by hand, to mean what this compiles to:
// clipc: examples/gallery/water_reflection.hlsl -T vs_5_0
layout(std140, binding = 0, row_major) uniform Camera {
    mat4 view_projection;
    vec3 eye;
    float time;
};
layout(std140, binding = 1, row_major) uniform Object {
    mat4 world;
    vec4 tint;
};
layout(std140, binding = 2) uniform Clip {
    vec4 water_plane;
};
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 0) out vec3 out_normal;
layout(location = 1) out vec3 to_eye;
layout(location = 2) out vec2 out_uv;
out float gl_ClipDistance[1];

void main() {
    vec4 placed = world * vec4(position, 1.0);
    placed.y = -placed.y;
    vec4 clip = view_projection * placed;
    gl_Position = clip;
    gl_ClipDistance[0] = dot(clip, water_plane);
    out_normal = normalize(mat3(world) * normal) * vec3(1.0, -1.0, 1.0);
    to_eye = eye - placed.xyz;
    out_uv = uv + vec2(0.02 * sin(time), 0.0);
}
