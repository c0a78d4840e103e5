#version 450

struct VS_OUTPUT {
    vec4 Position;
    vec4 Color;
    vec2 TexCoord;
};

layout(std140, binding = 0, row_major) uniform Globals {  // b0
    mat4 WorldViewProjection;
    vec4 LightDirection;
    vec4 Ambient;
    vec4 Diffuse;
};

layout(location = 0) in vec4 in_POSITION0;  // POSITION0
layout(location = 1) in vec3 in_NORMAL0;  // NORMAL0
layout(location = 2) in vec2 in_TEXCOORD0;  // TEXCOORD0

layout(location = 0) out vec4 vs_COLOR0;  // COLOR0
layout(location = 1) out vec2 vs_TEXCOORD0;  // TEXCOORD0

float saturate(float x) {
    return min(max(0.0, x), 1.0);  // 0 for NaN
}

VS_OUTPUT VertexMain(vec4 position, vec3 normal, vec2 uv) {
    VS_OUTPUT output_;
    output_.Position = WorldViewProjection * position;
    output_.Color = Ambient + Diffuse * saturate(dot(normal, -LightDirection.xyz));
    output_.TexCoord = uv;
    return output_;
}

void main() {
    VS_OUTPUT result = VertexMain(in_POSITION0, in_NORMAL0, in_TEXCOORD0);
    gl_Position = result.Position;
    vs_COLOR0 = result.Color;
    vs_TEXCOORD0 = result.TexCoord;
}
