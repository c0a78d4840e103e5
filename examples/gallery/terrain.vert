#version 450

layout(std140, binding = 0, row_major) uniform Terrain {  // b0
    mat4 view_projection;
    vec2 origin;
    float cell;
    float height_scale;
    vec2 texel;
    vec4 cut;
};

layout(binding = 0) uniform sampler2D heights;  // heights with linear_clamp

layout(location = 0) in vec2 in_POSITION0;  // POSITION0

layout(location = 0) out vec3 vs_NORMAL0;  // NORMAL0
layout(location = 1) out vec2 vs_TEXCOORD0;  // TEXCOORD0
// clip distances written: 0x1
out float gl_ClipDistance[1];

float Height(vec2 uv) {
    return textureLod(heights, uv, 0.0).x * height_scale;
}

vec4 shader_main(vec2 grid, out vec3 normal, out vec2 uv) {
    uv = grid * texel;
    float left = Height(uv - vec2(texel.x, 0.0));
    float right = Height(uv + vec2(texel.x, 0.0));
    float down = Height(uv - vec2(0.0, texel.y));
    float up = Height(uv + vec2(0.0, texel.y));
    normal = normalize(vec3(left - right, 2.0 * cell, down - up));
    vec2 xz = origin + grid * cell;
    return view_projection * vec4(xz.x, Height(uv), xz.y, 1.0);
}

void main() {
    vec3 normal;
    vec2 uv;
    vec4 result = shader_main(in_POSITION0, normal, uv);
    vs_NORMAL0 = normal;
    vs_TEXCOORD0 = uv;
    gl_Position = result;
    gl_ClipDistance[0] = dot(result, cut);
}
