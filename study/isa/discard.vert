#version 450
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Written by hand, to mean what this compiles to:
// clipc: study/program/method.hlsl -DPLANES=3 --lower=discard
layout(std140, binding = 0, row_major) uniform Draw {
    mat4 world_view_projection;
    mat4 world;
    vec4 planes[6];
};
layout(location = 0) in vec4 vertex;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 out_normal;
layout(location = 1) out vec3 distances;

void main() {
    vec4 position = world_view_projection * vertex;
    gl_Position = position;
    out_normal = mat3(world) * normal;
    distances = vec3(dot(position, planes[0]), dot(position, planes[1]), dot(position, planes[2]));
}
