#version 450

struct Cascade {
    mat4 view_projection;
    vec2 scale;
    float bias;
};

layout(std140, binding = 3) uniform Shadows {  // b3
    Cascade cascades[4];
    vec4 split;
};

layout(location = 0) in vec4 in_POSITION0;  // POSITION0
layout(location = 1) in vec4 in_INSTANCE0;  // INSTANCE0
layout(location = 2) in vec4 in_INSTANCE1;  // INSTANCE1
layout(location = 3) in vec4 in_INSTANCE2;  // INSTANCE2
layout(location = 4) in uint in_CASCADE0;  // CASCADE0

layout(location = 0) flat out uint vs_SLICE0;  // SLICE0

vec4 shader_main(vec4 position, vec4 row0, vec4 row1, vec4 row2, uint cascade, out uint slice) {
    slice = min(cascade, 3u);
    Cascade c = cascades[slice];
    vec3 world = vec3(dot(row0, position), dot(row1, position), dot(row2, position));
    vec4 clip = c.view_projection * vec4(world, 1.0);
    clip.xy *= c.scale;
    clip.z += c.bias * clip.w;
    return clip;
}

void main() {
    uint slice;
    vec4 result = shader_main(in_POSITION0, in_INSTANCE0, in_INSTANCE1, in_INSTANCE2, in_CASCADE0, slice);
    vs_SLICE0 = slice;
    gl_Position = result;
}
