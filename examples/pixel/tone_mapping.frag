#version 450

layout(std140, binding = 0) uniform Grading {  // b0
    float exposure;
    float bloom_strength;
    float vignette;
    float grain;
    vec3 lift;
    float time;
    vec3 gain;
    float saturation;
} grading_2;

layout(binding = 16) uniform sampler2D scene;  // t0 with linear_clamp : s0
layout(binding = 17) uniform sampler2D bloom;  // t1 with linear_clamp : s0
layout(binding = 18) uniform sampler3D grading;  // t2 with linear_clamp : s0

layout(location = 0) in vec2 vs_TEXCOORD0;  // uv : TEXCOORD0

layout(location = 0) out vec4 SV_Target0;  // main : SV_Target0

vec3 saturate(vec3 x) {
    return min(max(vec3(0.0), x), 1.0);  // 0 for NaN
}

vec3 Filmic(vec3 x) {
    const float a = 2.51;
    const float b = 0.03;
    const float c = 2.43;
    const float d = 0.59;
    const float e = 0.14;
    return saturate(x * (a * x + b) / (x * (c * x + d) + e));
}

float Luminance(vec3 colour) {
    return dot(colour, vec3(0.2126, 0.7152, 0.0722));
}

vec3 ToSrgb(vec3 colour) {
    return mix(1.055 * pow(abs(colour), vec3(1.0 / 2.4)) - 0.055, colour * 12.92, lessThanEqual(colour, vec3(0.0031308)));
}

float Noise(vec2 uv) {
    return fract(sin(dot(uv, vec2(12.9898, 78.233)) + grading_2.time) * 43758.547);
}

void main() {
    vec3 colour = texture(scene, vs_TEXCOORD0).xyz;
    colour += texture(bloom, vs_TEXCOORD0).xyz * grading_2.bloom_strength;
    vec2 centred = vs_TEXCOORD0 - 0.5;
    colour *= grading_2.exposure * (1.0 - grading_2.vignette * smoothstep(0.2, 0.9, length(centred) * 1.414));
    colour = Filmic(colour);
    colour = mix(vec3(Luminance(colour)), colour, vec3(grading_2.saturation));
    colour = pow(max(colour * grading_2.gain + grading_2.lift, 0.0), vec3(1.0 / 1.1));
    colour = ToSrgb(colour);
    colour = textureLod(grading, colour * (15.0 / 16.0) + 0.5 / 16.0, 0.0).xyz;
    SV_Target0 = vec4(colour + (Noise(vs_TEXCOORD0) - 0.5) * grading_2.grain, Luminance(colour));
}
