#version 450

layout(quads, fractional_even_spacing, ccw) in;

layout(std140, binding = 0) uniform Frame {  // b0
    layout(row_major) mat4 view_projection;
    vec4 water_plane;
    vec3 eye;
    float height;
    float cuts_at_one_unit;
} frame;

layout(binding = 64) uniform sampler2D heights;  // t0 with clamped : s0

layout(location = 0) in vec3 hs_POSITION0[];  // position : POSITION0

layout(location = 0) out vec3 ds_NORMAL0;  // normal : NORMAL0
layout(location = 1) out vec2 ds_TEXCOORD0;  // uv : TEXCOORD0
// clip distances written: 0x1
out float gl_ClipDistance[1];

float HeightAt(vec2 uv) {
    return frame.height * textureLod(heights, uv, 0.0).x;
}

void main() {
    vec2 uv = gl_TessCoord.xy;
    const float STEP = 1.0 / 256.0;
    vec3 near = mix(hs_POSITION0[0], hs_POSITION0[1], uv.x);
    vec3 far = mix(hs_POSITION0[2], hs_POSITION0[3], uv.x);
    vec3 position = mix(near, far, uv.y);
    position.y += HeightAt(uv);
    vec2 slope = vec2(HeightAt(uv + vec2(STEP, 0.0)) - HeightAt(uv - vec2(STEP, 0.0)), HeightAt(uv + vec2(0.0, STEP)) - HeightAt(uv - vec2(0.0, STEP)));
    vec4 position_2 = frame.view_projection * vec4(position, 1.0);
    ds_NORMAL0 = normalize(vec3(-slope.x, 2.0 * STEP, -slope.y));
    ds_TEXCOORD0 = uv;
    gl_Position = position_2;
    gl_ClipDistance[0] = dot(position_2, frame.water_plane);
}
