#version 450

layout(std140, binding = 0) uniform Globals {  // b0
    layout(row_major) mat4 WorldViewProjection;
    vec4 LightDirection;
    vec4 Ambient;
    vec4 Diffuse;
} globals;

layout(location = 0) in vec4 in_POSITION0;  // position : POSITION0
layout(location = 1) in vec3 in_NORMAL0;  // normal : NORMAL0
layout(location = 2) in vec2 in_TEXCOORD0;  // uv : TEXCOORD0

layout(location = 0) out vec4 vs_COLOR0;  // Color : COLOR0
layout(location = 1) out vec2 vs_TEXCOORD0;  // TexCoord : TEXCOORD0

float saturate(float x) {
    return min(max(0.0, x), 1.0);  // 0 for NaN
}

void main() {
    gl_Position = globals.WorldViewProjection * in_POSITION0;
    vs_COLOR0 = globals.Ambient + globals.Diffuse * saturate(dot(in_NORMAL0, -globals.LightDirection.xyz));
    vs_TEXCOORD0 = in_TEXCOORD0;
}
