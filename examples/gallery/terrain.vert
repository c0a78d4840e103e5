#version 450

layout(std140, binding = 0) uniform Terrain {  // b0
    layout(row_major) mat4 view_projection;
    vec2 origin;
    float cell;
    float height_scale;
    vec2 texel;
    vec4 cut;
} terrain;

layout(binding = 0) uniform sampler2D heights;  // t0 with linear_clamp : s0

layout(location = 0) in vec2 in_POSITION0;  // grid : POSITION0

layout(location = 0) out vec3 vs_NORMAL0;  // normal : NORMAL0
layout(location = 1) out vec2 vs_TEXCOORD0;  // uv : TEXCOORD0
// clip distances written: 0x1
out float gl_ClipDistance[1];

float Height(vec2 uv) {
    return textureLod(heights, uv, 0.0).x * terrain.height_scale;
}

void main() {
    vs_TEXCOORD0 = in_POSITION0 * terrain.texel;
    float left = Height(vs_TEXCOORD0 - vec2(terrain.texel.x, 0.0));
    float right = Height(vs_TEXCOORD0 + vec2(terrain.texel.x, 0.0));
    float down = Height(vs_TEXCOORD0 - vec2(0.0, terrain.texel.y));
    float up = Height(vs_TEXCOORD0 + vec2(0.0, terrain.texel.y));
    vs_NORMAL0 = normalize(vec3(left - right, 2.0 * terrain.cell, down - up));
    vec2 xz = terrain.origin + in_POSITION0 * terrain.cell;
    vec4 result = terrain.view_projection * vec4(xz.x, Height(vs_TEXCOORD0), xz.y, 1.0);
    gl_Position = result;
    gl_ClipDistance[0] = dot(result, terrain.cut);
}
