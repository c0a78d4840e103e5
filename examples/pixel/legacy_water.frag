#version 450

layout(std140, binding = 0) uniform Globals {  // b0
    vec4 time;
    vec4 deep_colour;
    vec4 sun;
    vec4 eye;
    vec3 fog_colour;
    vec2 fog;
} globals;

layout(binding = 17) uniform sampler2D mirrored;  // s1
layout(binding = 18) uniform sampler2D below;  // s2
layout(binding = 19) uniform samplerCube sky;  // s3
layout(binding = 16) uniform sampler2D waves;  // s0

layout(location = 0) in vec4 vs_TEXCOORD0;  // projected : TEXCOORD0
layout(location = 1) in vec3 vs_TEXCOORD1;  // world : TEXCOORD1
layout(location = 2) in vec4 vs_TEXCOORD2;  // uv : TEXCOORD2
layout(location = 3) in float vs_TEXCOORD3;  // depth : TEXCOORD3
layout(location = 4) in vec4 vs_COLOR0;  // colour : COLOR0

layout(location = 0) out vec4 SV_Target0;  // main : COLOR0

float saturate(float x) {
    return min(max(0.0, x), 1.0);  // 0 for NaN
}

float pow5(float x) {
    float x2 = x * x;
    return x * (x2 * x2);
}

vec3 Wave(vec2 uv) {
    return texture(waves, uv).xyz * 2.0 - 1.0;
}

void main() {
    vec4 colour = vs_COLOR0;
    float facing = gl_FrontFacing ? 1.0 : -1.0;
    vec3 n = Wave(vs_TEXCOORD2.xy + globals.time.xx) + Wave(vs_TEXCOORD2.zw - globals.time.xy * 0.7);
    n = normalize(vec3(n.xy * 0.5, n.z)).xzy;
    if (facing < 0.0) {
        n = -n;
    }
    vec3 v = normalize(globals.eye.xyz - vs_TEXCOORD1);
    float fresnel = saturate(0.02 + 0.98 * pow5(1.0 - saturate(dot(v, n))));
    vec4 shifted = vs_TEXCOORD0;
    shifted.xy += n.xz * (0.1 * shifted.w);
    vec3 up = textureProj(mirrored, shifted).xyz;
    vec3 down = textureProj(below, shifted).xyz;
    down = mix(globals.deep_colour.xyz, down, saturate(exp(-vs_TEXCOORD3 * globals.deep_colour.w)));
    float glint = pow(saturate(dot(reflect(-v, n), globals.sun.xyz)), 256.0) * globals.sun.w;
    vec3 c = mix(down, up, fresnel) + glint + texture(sky, reflect(-v, n)).xyz * 0.1;
    c = mix(globals.fog_colour, c, saturate((globals.fog.y - length(globals.eye.xyz - vs_TEXCOORD1)) / (globals.fog.y - globals.fog.x)));
    vec4 result = vec4(c * colour.xyz, colour.w);
    SV_Target0 = result;
}
