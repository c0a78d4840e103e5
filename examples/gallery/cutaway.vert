#version 450

struct Varyings {
    vec4 position;
    vec3 below;
    vec3 above;
    float culled;
};

layout(std140, binding = 0, row_major) uniform Box {  // b0
    mat4 view_projection;
    vec3 low;
    bool enabled;
    vec3 high;
    float fade_radius;
};

layout(location = 0) in vec3 in_POSITION0;  // POSITION0

// clip distances written: 0x7f
// cull distances written: 0x1
out float gl_ClipDistance[7];
out float gl_CullDistance[1];

Varyings shader_main(vec3 position) {
    Varyings o;
    o.position = view_projection * vec4(position, 1.0);
    o.below = enabled ? position - low : vec3(1.0);
    o.above = enabled ? high - position : vec3(1.0);
    o.culled = fade_radius - length(position);
    return o;
}

void main() {
    Varyings result = shader_main(in_POSITION0);
    gl_Position = result.position;
    gl_ClipDistance[0] = result.below.x;
    gl_ClipDistance[1] = result.below.y;
    gl_ClipDistance[2] = result.below.z;
    gl_ClipDistance[3] = 0.0;
    gl_ClipDistance[4] = result.above.x;
    gl_ClipDistance[5] = result.above.y;
    gl_ClipDistance[6] = result.above.z;
    gl_CullDistance[0] = result.culled;
}
