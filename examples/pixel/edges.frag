#version 450

layout(std140, binding = 0) uniform Globals {  // b0
    vec2 texel;
    float threshold;
    float span;
} globals;

layout(binding = 16) uniform sampler2D image;  // t0 with linear_clamp : s0

layout(location = 0) noperspective in vec2 vs_TEXCOORD0;  // uv : TEXCOORD0

layout(location = 0) out vec4 SV_Target0;  // main : SV_Target0

vec3 Fetch(vec2 uv) {
    return textureLod(image, uv, 0.0).xyz;
}

float Luminance(vec3 colour) {
    return dot(colour, vec3(0.2126, 0.7152, 0.0722));
}

vec4 shader_main(vec2 uv) {
    vec3 centre = Fetch(uv);
    float m = Luminance(centre);
    float nw = Luminance(Fetch(uv + vec2(-1.0, -1.0) * globals.texel));
    float ne = Luminance(Fetch(uv + vec2(1.0, -1.0) * globals.texel));
    float sw = Luminance(Fetch(uv + vec2(-1.0, 1.0) * globals.texel));
    float se = Luminance(Fetch(uv + vec2(1.0) * globals.texel));
    float low = min(m, min(min(nw, ne), min(sw, se)));
    float high = max(m, max(max(nw, ne), max(sw, se)));
    if (high - low < max(0.05, high * globals.threshold)) {
        return vec4(centre, 1.0);
    }
    vec2 along = vec2(sw + se - (nw + ne), nw + sw - (ne + se));
    float reduce = max((nw + ne + sw + se) * 0.03125, 1.0 / 128.0);
    float scale = 1.0 / (min(abs(along.x), abs(along.y)) + reduce);
    along = clamp(along * scale, -globals.span, globals.span) * globals.texel;
    vec3 narrow = 0.5 * (Fetch(uv + along * (1.0 / 3.0 - 0.5)) + Fetch(uv + along * (2.0 / 3.0 - 0.5)));
    vec3 wide = narrow * 0.5 + 0.25 * (Fetch(uv - along * 0.5) + Fetch(uv + along * 0.5));
    float bright = Luminance(wide);
    return vec4(bright < low || bright > high ? narrow : wide, 1.0);
}

void main() {
    SV_Target0 = shader_main(vs_TEXCOORD0);
}
