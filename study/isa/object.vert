#version 450
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Written by hand, to mean what this compiles to:
// clipc: study/program/method.hlsl -DPLANES=6 --plane-space=object
layout(std140, binding = 0, row_major) uniform Draw {
    mat4 world_view_projection;
    mat4 world;
    vec4 planes[6];
};
layout(location = 0) in vec4 vertex;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 out_normal;
out float gl_ClipDistance[6];

void main() {
    gl_Position = world_view_projection * vertex;
    out_normal = mat3(world) * normal;
    gl_ClipDistance[0] = dot(vertex, planes[0]);
    gl_ClipDistance[1] = dot(vertex, planes[1]);
    gl_ClipDistance[2] = dot(vertex, planes[2]);
    gl_ClipDistance[3] = dot(vertex, planes[3]);
    gl_ClipDistance[4] = dot(vertex, planes[4]);
    gl_ClipDistance[5] = dot(vertex, planes[5]);
}
