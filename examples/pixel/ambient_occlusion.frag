#version 450

layout(std140, binding = 0) uniform View {  // b0
    vec4 projection;
    vec2 size;
    float radius;
    float power;
} view;

layout(binding = 17) uniform sampler2D noise;  // t1 with point_wrap : s1
layout(binding = 16) uniform sampler2D depth_buffer;  // t0 with point_clamp : s0

layout(origin_upper_left) in vec4 gl_FragCoord;
layout(location = 0) in vec2 vs_TEXCOORD0;  // uv : TEXCOORD0

layout(location = 0) out float SV_Target0;  // main : SV_Target0

float saturate(float x) {
    return min(max(0.0, x), 1.0);  // 0 for NaN
}

const int kSamples = 12;
const vec3 kKernel[12] = vec3[12](vec3(0.355, -0.271, 0.124), vec3(-0.062, 0.118, 0.051), vec3(0.211, 0.402, 0.31), vec3(-0.478, 0.033, 0.217), vec3(0.087, -0.092, 0.044), vec3(-0.253, -0.338, 0.441), vec3(0.514, 0.227, 0.402), vec3(-0.133, 0.547, 0.288), vec3(0.029, -0.618, 0.34), vec3(-0.391, 0.41, 0.521), vec3(0.66, -0.148, 0.287), vec3(0.012, 0.009, 0.93));

float ViewDepth(vec2 uv) {
    return view.projection.w / (textureLod(depth_buffer, uv, 0.0).x - view.projection.z);
}

vec3 ViewPosition(vec2 uv) {
    float z = ViewDepth(uv);
    return vec3((uv * 2.0 - 1.0) * vec2(1.0, -1.0) / view.projection.xy * z, z);
}

vec2 Uv(vec3 view_2) {
    return view_2.xy * view.projection.xy / view_2.z * vec2(0.5, -0.5) + 0.5;
}

void main() {
    vec3 p = ViewPosition(vs_TEXCOORD0);
    vec3 n = normalize(cross(dFdx(p), -dFdy(p)));
    vec2 spin = textureLod(noise, gl_FragCoord.xy / 4.0, 0.0).xy * 2.0 - 1.0;
    vec3 t = normalize(vec3(spin, 0.0) - n * dot(vec3(spin, 0.0), n));
    mat3 frame = mat3(t, cross(n, t), n);
    float hidden = 0.0;
    for (int i = 0; i < kSamples; i++) {
        vec3 s = p + frame * kKernel[i] * view.radius;
        float z = ViewDepth(Uv(s));
        float near = smoothstep(0.0, 1.0, view.radius / max(abs(p.z - z), 1e-04));
        hidden += float(z <= s.z - 0.02 ? 1 : 0) * near;
    }
    SV_Target0 = pow(saturate(1.0 - hidden / float(kSamples)), view.power);
}
