#version 450

layout(std140, binding = 0) uniform Sun {  // b0
    mat4 to_cascade[4];
    vec4 cascade_ends;
    vec3 sun_direction;
    float bias;
    vec3 sun_colour;
    float texel;
    vec3 sky_colour;
    float fog_density;
} sun;

layout(binding = 17) uniform sampler2D albedo_map;  // t1 with linear_wrap : s1
layout(binding = 16) uniform sampler2DArrayShadow shadow_maps;  // t0 with less : s0

layout(location = 0) in vec3 vs_TEXCOORD0;  // world : TEXCOORD0
layout(location = 1) in float vs_TEXCOORD1;  // depth : TEXCOORD1
layout(location = 2) in vec3 vs_TEXCOORD2;  // normal : TEXCOORD2
layout(location = 3) in vec2 vs_TEXCOORD3;  // uv : TEXCOORD3

layout(location = 0) out vec4 SV_Target0;  // main : SV_Target0

float saturate(float x) {
    return min(max(0.0, x), 1.0);  // 0 for NaN
}

int CascadeOf(float depth) {
    int cascade = 0;
    for (int i = 0; i < 4 - 1; i++) {
        if (depth > sun.cascade_ends[i]) {
            cascade = i + 1;
        }
    }
    return cascade;
}

float Lit(vec3 world, vec3 normal, int cascade) {
    vec4 p = sun.to_cascade[cascade] * vec4(world + normal * sun.bias * float(cascade + 1), 1.0);
    vec2 uv = p.xy * vec2(0.5, -0.5) + 0.5;
    if (any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) {
        return 1.0;
    }
    float lit = 0.0;
    for (int y = -1; y <= 1; y++) {
        for (int x = -1; x <= 1; x++) {
            lit += textureGrad(shadow_maps, vec4(vec3(uv + vec2(float(x), float(y)) * sun.texel, float(cascade)), p.z - sun.bias), vec2(0.0), vec2(0.0));
        }
    }
    return lit / float((2 * 1 + 1) * (2 * 1 + 1));
}

vec3 ToLinear(vec3 srgb) {
    return mix(pow((abs(srgb) + 0.055) / 1.055, vec3(2.4)), srgb / 12.92, lessThanEqual(srgb, vec3(0.04045)));
}

vec3 Fog(vec3 colour, vec3 fog, float distance_, float density) {
    return mix(fog, colour, saturate(exp2(-distance_ * density)));
}

void main() {
    vec3 n = normalize(vs_TEXCOORD2);
    int cascade = CascadeOf(vs_TEXCOORD1);
    float lit = Lit(vs_TEXCOORD0, n, cascade);
    float edge = saturate((sun.cascade_ends[cascade] - vs_TEXCOORD1) * 0.2);
    if (edge < 1.0 && cascade + 1 < 4) {
        lit = mix(Lit(vs_TEXCOORD0, n, cascade + 1), lit, edge);
    }
    vec3 albedo = ToLinear(texture(albedo_map, vs_TEXCOORD3).xyz);
    vec3 light = sun.sun_colour * (lit * saturate(dot(n, -sun.sun_direction))) + sun.sky_colour * (n.y * 0.5 + 0.5);
    SV_Target0 = vec4(Fog(albedo * light, sun.sky_colour, vs_TEXCOORD1, sun.fog_density), 1.0);
}
