#version 450
#extension GL_ARB_shader_draw_parameters : require

struct Particle {
    vec3 position;
    float size;
    vec4 color;
};

layout(std140, binding = 0) uniform Camera {  // b0
    layout(row_major) mat4 view;
    layout(row_major) mat4 projection;
} camera;

layout(std430, binding = 0) readonly buffer particles_block {  // t0
    Particle particles[];
};

layout(location = 0) out vec4 vs_COLOR0;  // color : COLOR0
layout(location = 1) out vec2 vs_TEXCOORD0;  // uv : TEXCOORD0

void main() {
    uint id = uint(gl_VertexID - gl_BaseVertexARB);
    Particle p = particles[id / 6u];
    uint corner = id % 6u;
    vec2 uv = vec2(float(corner == 1u || corner == 2u || corner == 4u), float(corner == 2u || corner >= 4u));
    vec4 view_position = camera.view * vec4(p.position, 1.0);
    view_position.xy += (uv * 2.0 - 1.0) * p.size;
    gl_Position = camera.projection * view_position;
    vs_COLOR0 = p.color;
    vs_TEXCOORD0 = uv;
}
