#version 450
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Written by hand, to mean what this compiles to:
// clipc: study/program/method.hlsl -DPLANES=0
layout(std140, binding = 0, row_major) uniform Draw {
    mat4 world_view_projection;
    mat4 world;
    vec4 planes[6];
};
layout(location = 0) in vec4 vertex;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 out_normal;

void main() {
    gl_Position = world_view_projection * vertex;
    out_normal = mat3(world) * normal;
}
