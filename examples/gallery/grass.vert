#version 450
#extension GL_ARB_shader_draw_parameters : require

layout(std140, binding = 0) uniform Wind {  // b0
    vec2 direction;
    float strength;
    float time;
} wind;

layout(std140, binding = 1) uniform Camera {  // b1
    layout(row_major) mat4 view_projection;
} camera;

layout(location = 0) in vec3 in_ROOT0;  // root : ROOT0

layout(location = 0) out float vs_SHADE0;  // shade : SHADE0

const vec2 kCorners[4] = vec2[4](vec2(-1.0, 0.0), vec2(1.0, 0.0), vec2(-1.0, 1.0), vec2(1.0));

uint Hash(uint x) {
    x ^= x >> 16;
    x *= 2146121005u;
    x ^= x >> 15;
    return x;
}

float Random(uint seed) {
    return float(Hash(seed) & 16777215u) / 16777216.0;
}

void main() {
    uint corner = uint(gl_VertexID - gl_BaseVertexARB);
    uint blade = uint(gl_InstanceID);
    vec2 offset = kCorners[corner & 3u];
    float height = mix(0.4, 1.0, Random(blade));
    float bend = offset.y * offset.y * wind.strength * sin(wind.time + 6.2831855 * Random(blade + 17u));
    vec3 position = in_ROOT0 + vec3(offset.x * 0.02, offset.y * height, 0.0);
    position.xz += wind.direction * bend;
    float shade = 0.5 + 0.5 * offset.y;
    gl_Position = camera.view_projection * vec4(position, 1.0);
    vs_SHADE0 = shade;
}
