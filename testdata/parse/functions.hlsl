// RUN: %clipc --dump=ast %s | FileCheck %s
// AUTOUPDATE
float4 prototype(float4 p, float s);
float4 prototype(float4 p, float s) { return p * s; }
void nothing(void) {}
void all(in float a, out float4 b : COLOR, inout float c, uniform float4x4 d, const float e = 1,
         float f[3], float4, const in float g, [[vk::location(1)]] float h : H) {}
inline precise float3 qualified() { return 0; }
static export float exported();
float4 with_semantic(float4 p : POSITION) : SV_Position { return p; }
Texture2D<float4> resource(SamplerState s, Texture2D t[4]) { return t[0]; }
void stage(triangle Vertex input[3], point Vertex p[1], inout TriangleStream<Vertex> output) {}
struct Vertex { float4 p; } returns_struct() { Vertex v; return v; }
sampler s : register(s0);
float4 object(uniform sampler2D map : register(s1), float2 uv : TEXCOORD) : COLOR { return tex2D(map, uv); };
void body() {
  float declared_here(float x);
}
