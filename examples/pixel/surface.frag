#version 450

struct Light {
    vec3 position;
    float range;
    vec3 colour;
    float cone;
    vec3 direction;
    uint kind;
};

struct Input {
    vec4 position;
    vec3 world;
    vec3 normal;
    vec4 tangent;
    vec2 uv;
    bool is_front;
};

struct Surface {
    vec3 albedo;
    float roughness;
    vec3 normal;
    float metalness;
    vec3 position;
    float occlusion;
};

layout(std140, binding = 0) uniform Frame {  // b0
    vec3 eye;
    float exposure;
    Light lights[4];
    vec4 ambient[9];
} frame;

layout(std140, binding = 1) uniform Material {  // b1
    vec4 base_colour;
    vec3 emission;
    float alpha_cutoff;
    vec2 roughness_metalness;
    vec2 tiling;
} material;

layout(binding = 16) uniform sampler2D albedo_map;  // t0 with trilinear : s0
layout(binding = 18) uniform sampler2D surface_map;  // t2 with trilinear : s0
layout(binding = 19) uniform samplerCube environment;  // t3 with trilinear : s0
layout(binding = 20) uniform sampler2D emission_map;  // t4 with trilinear : s0
layout(binding = 17) uniform sampler2D normal_map;  // t1 with trilinear : s0

layout(origin_upper_left) in vec4 gl_FragCoord;
layout(location = 0) in vec3 vs_POSITION0;  // world : POSITION0
layout(location = 1) in vec3 vs_NORMAL0;  // normal : NORMAL0
layout(location = 2) in vec4 vs_TANGENT0;  // tangent : TANGENT0
layout(location = 3) in vec2 vs_TEXCOORD0;  // uv : TEXCOORD0

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
bool is_discarded = false;

vec3 NormalOf(Input input_, vec2 uv) {
    vec3 n = normalize(input_.is_front ? input_.normal : -input_.normal);
    vec3 t = normalize(input_.tangent.xyz - n * dot(n, input_.tangent.xyz));
    vec3 b = cross(n, t) * input_.tangent.w;
    vec3 texel;
    texel.xy = texture(normal_map, uv).xy * 2.0 - 1.0;
    texel.z = sqrt(saturate(1.0 - dot(texel.xy, texel.xy)));
    return normalize(mat3(t, b, n) * texel);
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

vec3 Shade(Surface surface, Light light, vec3 view) {
    vec3 to_light = light.position - surface.position;
    float attenuation = 1.0;
    if (light.kind == 2u) {
        to_light = -light.direction;
    } else {
        attenuation = Attenuation(light, to_light);
    }
    vec3 l = normalize(to_light);
    vec3 h = normalize(l + view);
    float n_dot_l = saturate(dot(surface.normal, l));
    float n_dot_v = abs(dot(surface.normal, view)) + 1e-05;
    float n_dot_h = saturate(dot(surface.normal, h));
    vec3 f0 = mix(vec3(0.04), surface.albedo, vec3(surface.metalness));
    vec3 fresnel = FresnelSchlick(f0, saturate(dot(view, h)));
    vec3 specular = fresnel * DistributionGgx(n_dot_h, surface.roughness) * VisibilitySmith(n_dot_l, n_dot_v, surface.roughness);
    vec3 diffuse = (1.0 - fresnel) * (1.0 - surface.metalness) * surface.albedo / kPi;
    return (diffuse + specular) * light.colour * (attenuation * n_dot_l);
}

vec3 Ambient(vec4 coefficients[9], vec3 n) {
    vec3 light = coefficients[0].xyz;
    light += coefficients[1].xyz * n.y + coefficients[2].xyz * n.z + coefficients[3].xyz * n.x;
    light += coefficients[4].xyz * (n.x * n.y) + coefficients[5].xyz * (n.y * n.z);
    light += coefficients[6].xyz * (3.0 * n.z * n.z - 1.0) + coefficients[7].xyz * (n.x * n.z);
    return max(light + coefficients[8].xyz * (n.x * n.x - n.y * n.y), 0.0);
}

void main() {
    Input input_ = Input(vec4(gl_FragCoord.xyz, 1.0 / gl_FragCoord.w), vs_POSITION0, vs_NORMAL0, vs_TANGENT0, vs_TEXCOORD0, gl_FrontFacing);
    vec2 uv = input_.uv * material.tiling;
    vec4 texel = texture(albedo_map, uv) * material.base_colour;
    if (texel.w - material.alpha_cutoff < 0.0) {
        is_discarded = true;
    }
    vec3 map = texture(surface_map, uv).xyz;
    Surface surface;
    surface.albedo = texel.xyz;
    surface.occlusion = map.x;
    surface.roughness = clamp(map.y * material.roughness_metalness.x, 0.045, 1.0);
    surface.metalness = saturate(map.z * material.roughness_metalness.y);
    surface.normal = NormalOf(input_, uv);
    surface.position = input_.world;
    vec3 view = normalize(frame.eye - input_.world);
    vec3 colour = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        colour += Shade(surface, frame.lights[i], view);
    }
    vec3 diffuse = surface.albedo * (1.0 - surface.metalness) * Ambient(frame.ambient, surface.normal);
    vec3 f0 = mix(vec3(0.04), surface.albedo, vec3(surface.metalness));
    vec3 mirrored = textureLod(environment, reflect(-view, surface.normal), surface.roughness * 7.0).xyz;
    vec3 fresnel = FresnelSchlick(f0, saturate(dot(surface.normal, view)));
    colour += (diffuse + mirrored * fresnel) * surface.occlusion;
    colour += material.emission * texture(emission_map, uv).xyz;
    SV_Target0 = vec4(colour * frame.exposure, texel.w);
    if (is_discarded) {
        discard;
    }
}
