#version 450

struct Cascade {
    mat4 view_projection;
    vec2 scale;
    float bias;
};

layout(std140, binding = 3) uniform Shadows {  // b3
    Cascade cascades[4];
    vec4 split;
} shadows;

layout(location = 0) in vec4 in_POSITION0;  // position : POSITION0
layout(location = 1) in vec4 in_INSTANCE0;  // row0 : INSTANCE0
layout(location = 2) in vec4 in_INSTANCE1;  // row1 : INSTANCE1
layout(location = 3) in vec4 in_INSTANCE2;  // row2 : INSTANCE2
layout(location = 4) in uint in_CASCADE0;  // cascade : CASCADE0

layout(location = 0) flat out uint vs_SLICE0;  // slice : SLICE0

void main() {
    vs_SLICE0 = min(in_CASCADE0, 3u);
    Cascade c = shadows.cascades[vs_SLICE0];
    vec3 world = vec3(dot(in_INSTANCE0, in_POSITION0), dot(in_INSTANCE1, in_POSITION0), dot(in_INSTANCE2, in_POSITION0));
    gl_Position = c.view_projection * vec4(world, 1.0);
    gl_Position.xy *= c.scale;
    gl_Position.z += c.bias * gl_Position.w;
}
