#version 450

struct Hit {
    vec2 uv;
    float height;
};

layout(std140, binding = 0) uniform Wall {  // b0
    float depth;
    int steps_x;
    int steps_y;
    float shininess;
    vec3 light_colour;
    vec4 ambient;
} wall;

layout(binding = 17) uniform sampler2D height_map;  // t1 with anisotropic : s0
layout(binding = 16) uniform sampler2D albedo_map;  // t0 with anisotropic : s0

layout(location = 0) in vec2 vs_TEXCOORD0;  // uv : TEXCOORD0
layout(location = 1) in vec3 vs_TEXCOORD1;  // view : TEXCOORD1
layout(location = 2) in vec3 vs_TEXCOORD2;  // light : TEXCOORD2

layout(location = 0) out vec4 SV_Target0;  // main : SV_Target0

ivec2 steps() {  // offset 4
    return ivec2(wall.steps_x, wall.steps_y);
}

float saturate(float x) {
    return min(max(0.0, x), 1.0);  // 0 for NaN
}

int to_int(float x) {
    return x < 2147483648.0 ? int(max(-2147483648.0, x)) : x > 0.0 ? 2147483647 : 0;
}

Hit Follow(vec2 uv, vec3 view, vec2 dx, vec2 dy) {
    int count = to_int(mix(float(steps().y), float(steps().x), saturate(view.z)));
    float layer = 1.0 / float(count);
    vec2 step_ = view.xy / view.z * wall.depth * layer;
    float ray = 1.0;
    float height = textureGrad(height_map, uv, dx, dy).w;
    float before = height;
    while (height < ray) {
        before = height - ray;
        ray -= layer;
        uv -= step_;
        height = textureGrad(height_map, uv, dx, dy).w;
    }
    float after = height - ray;
    float weight = after / max(after - before, 1e-05);
    Hit hit = Hit(uv + step_ * weight, height);
    return hit;
}

vec3 BlinnPhong(vec3 normal, vec3 to_light, vec3 view, vec3 colour, float power) {
    vec3 h = normalize(to_light + view);
    float diffuse = saturate(dot(normal, to_light));
    float specular = pow(saturate(dot(normal, h)), power);
    return colour * diffuse + specular * float(diffuse > 0.0);
}

void main() {
    vec3 view = normalize(vs_TEXCOORD1);
    vec3 light = normalize(vs_TEXCOORD2);
    vec2 dx = dFdx(vs_TEXCOORD0);
    vec2 dy = -dFdy(vs_TEXCOORD0);
    Hit hit = Follow(vs_TEXCOORD0, view, dx, dy);
    if (any(lessThan(hit.uv, vec2(0.0))) || any(greaterThan(hit.uv, vec2(1.0)))) {
        discard;
    }
    vec3 n = textureGrad(height_map, hit.uv, dx, dy).xyz * 2.0 - 1.0;
    vec4 albedo = textureGrad(albedo_map, hit.uv, dx, dy);
    vec3 lit = BlinnPhong(normalize(n), light, view, wall.light_colour, wall.shininess) + wall.ambient.xyz;
    SV_Target0 = vec4(albedo.xyz * lit, albedo.w);
}
