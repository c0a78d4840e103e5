#version 450

struct Light {
    vec3 position;
    float range;
    vec3 colour;
    float cone;
    vec3 direction;
    uint kind;
};

struct Surface {
    vec3 albedo;
    float roughness;
    vec3 normal;
    float metalness;
    vec3 position;
    float occlusion;
};

layout(std140, binding = 0) uniform View {  // b0
    layout(row_major) mat4 clip_to_world;
    vec3 eye;
    float pad;
    vec2 size;
} view;

layout(std430, binding = 3) readonly buffer lights_block {  // t3
    Light lights[];
};
layout(binding = 18) uniform sampler2D depth_buffer;  // t2
layout(binding = 16) uniform sampler2D albedo_and_metalness;  // t0
layout(binding = 17) uniform sampler2D normal_and_roughness;  // t1
layout(binding = 21) uniform usampler2D tiles;  // t5
layout(binding = 20) uniform usamplerBuffer light_indices;  // t4

layout(origin_upper_left) in vec4 gl_FragCoord;

layout(location = 0) out vec4 SV_Target0;  // main : SV_Target0

float saturate(float x) {
    return min(max(0.0, x), 1.0);  // 0 for NaN
}

float smoothstep_(float a, float b, float x) {
    float t = saturate((x - a) / (b - a));
    return t * t * (t * -2.0 + 3.0);
}

float pow5(float x) {
    float x2 = x * x;
    return x * (x2 * x2);
}

const float kPi = 3.1415927;
const uint kTile = 16u;

vec3 DecodeNormal(vec2 encoded) {
    vec2 f = encoded * 2.0 - 1.0;
    vec3 n = vec3(f, 1.0 - abs(f.x) - abs(f.y));
    float t = saturate(-n.z);
    n.xy += mix(vec2(t), vec2(-t), greaterThanEqual(n.xy, vec2(0.0)));
    return normalize(n);
}

float Square(float x) {
    return x * x;
}

float Attenuation(Light light, vec3 to_light) {
    float distance2 = dot(to_light, to_light);
    float window = saturate(1.0 - Square(distance2 / Square(light.range)));
    float attenuation = Square(window) / max(distance2, 1e-04);
    if (light.kind == 1u) {
        float angle = dot(normalize(-to_light), light.direction);
        attenuation *= smoothstep_(light.cone, mix(light.cone, 1.0, 0.25), angle);
    }
    return attenuation;
}

vec3 FresnelSchlick(vec3 f0, float v_dot_h) {
    return f0 + (1.0 - f0) * pow5(1.0 - v_dot_h);
}

float DistributionGgx(float n_dot_h, float roughness) {
    float a = Square(roughness);
    float d = Square(n_dot_h) * (Square(a) - 1.0) + 1.0;
    return Square(a) / max(kPi * Square(d), 1e-06);
}

float VisibilitySmith(float n_dot_l, float n_dot_v, float roughness) {
    float a = Square(roughness);
    float l = n_dot_v * (n_dot_l * (1.0 - a) + a);
    float v = n_dot_l * (n_dot_v * (1.0 - a) + a);
    return 0.5 / max(l + v, 1e-05);
}

vec3 Shade(Surface surface, Light light, vec3 view_2) {
    vec3 to_light = light.position - surface.position;
    float attenuation = 1.0;
    if (light.kind == 2u) {
        to_light = -light.direction;
    } else {
        attenuation = Attenuation(light, to_light);
    }
    vec3 l = normalize(to_light);
    vec3 h = normalize(l + view_2);
    float n_dot_l = saturate(dot(surface.normal, l));
    float n_dot_v = abs(dot(surface.normal, view_2)) + 1e-05;
    float n_dot_h = saturate(dot(surface.normal, h));
    vec3 f0 = mix(vec3(0.04), surface.albedo, vec3(surface.metalness));
    vec3 fresnel = FresnelSchlick(f0, saturate(dot(view_2, h)));
    vec3 specular = fresnel * DistributionGgx(n_dot_h, surface.roughness) * VisibilitySmith(n_dot_l, n_dot_v, surface.roughness);
    vec3 diffuse = (1.0 - fresnel) * (1.0 - surface.metalness) * surface.albedo / kPi;
    return (diffuse + specular) * light.colour * (attenuation * n_dot_l);
}

void main() {
    ivec3 texel = ivec3(ivec2(gl_FragCoord.xy), 0);
    float depth = texelFetch(depth_buffer, texel.xy, texel.z).x;
    if (depth >= 1.0) {
        discard;
    }
    vec2 ndc = gl_FragCoord.xy / view.size * vec2(2.0, -2.0) + vec2(-1.0, 1.0);
    vec4 world = view.clip_to_world * vec4(ndc, depth, 1.0);
    vec4 g0 = texelFetch(albedo_and_metalness, texel.xy, texel.z);
    vec4 g1 = texelFetch(normal_and_roughness, texel.xy, texel.z);
    Surface surface = Surface(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    surface.position = world.xyz / world.w;
    surface.albedo = g0.xyz;
    surface.metalness = g0.w;
    surface.normal = DecodeNormal(g1.xy);
    surface.roughness = max(g1.z, 0.05);
    surface.occlusion = g1.w;
    vec3 view_2 = normalize(view.eye - surface.position);
    vec3 colour = 0.03 * surface.albedo * surface.occlusion;
    uvec2 tile = texelFetch(tiles, ivec2(uvec2(gl_FragCoord.xy) / kTile), 0).xy;
    for (uint i = 0u; i < tile.y; ++i) {
        Light light = lights[texelFetch(light_indices, int(tile.x + i)).x];
        if (light.kind > 2u) {
            continue;
        }
        colour += Shade(surface, light, view_2);
    }
    SV_Target0 = vec4(colour, 1.0);
}
