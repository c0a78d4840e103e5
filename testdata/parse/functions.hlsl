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

// CHECK: prototype prototype : float4
// CHECK-NEXT:   parameter p : float4
// CHECK-NEXT:   parameter s : float
// CHECK-NEXT: function prototype : float4
// CHECK-NEXT:   parameter p : float4
// CHECK-NEXT:   parameter s : float
// CHECK-NEXT:   block
// CHECK-NEXT:     return (p * s)
// CHECK-NEXT: function nothing : void
// CHECK-NEXT:   block
// CHECK-NEXT: function all : void
// CHECK-NEXT:   parameter a : float in
// CHECK-NEXT:   parameter b : float4 out semantic COLOR
// CHECK-NEXT:   parameter c : float in out
// CHECK-NEXT:   parameter d : float4x4 uniform
// CHECK-NEXT:   parameter e : float const = 1
// CHECK-NEXT:   parameter f[3] : float
// CHECK-NEXT:   parameter <unnamed> : float4
// CHECK-NEXT:   parameter g : float const in
// CHECK-NEXT:   parameter h : float semantic H
// CHECK-NEXT:     attribute vk::location(1)
// CHECK-NEXT:   block
// CHECK-NEXT: function qualified : float3 inline precise
// CHECK-NEXT:   block
// CHECK-NEXT:     return 0
// CHECK-NEXT: prototype exported : float export static
// CHECK-NEXT: function with_semantic : float4 semantic SV_Position
// CHECK-NEXT:   parameter p : float4 semantic POSITION
// CHECK-NEXT:   block
// CHECK-NEXT:     return p
// CHECK-NEXT: function resource : Texture2D<float4>
// CHECK-NEXT:   parameter s : SamplerState
// CHECK-NEXT:   parameter t[4] : Texture2D
// CHECK-NEXT:   block
// CHECK-NEXT:     return t[0]
// CHECK-NEXT: function stage : void
// CHECK-NEXT:   parameter input[3] : Vertex
// CHECK-NEXT:   parameter p[1] : Vertex
// CHECK-NEXT:   parameter output : TriangleStream<Vertex> in out
// CHECK-NEXT:   block
// CHECK-NEXT: function returns_struct : Vertex
// CHECK-NEXT:   struct Vertex
// CHECK-NEXT:     field p : float4
// CHECK-NEXT:   block
// CHECK-NEXT:     variable v : Vertex
// CHECK-NEXT:     return v
// CHECK-NEXT: variable s : sampler register(s0)
// CHECK-NEXT: function object : float4 semantic COLOR
// CHECK-NEXT:   parameter map : sampler2D uniform register(s1)
// CHECK-NEXT:   parameter uv : float2 semantic TEXCOORD
// CHECK-NEXT:   block
// CHECK-NEXT:     return tex2D(map, uv)
// CHECK-NEXT: function body : void
// CHECK-NEXT:   block
// CHECK-NEXT:     prototype declared_here : float
// CHECK-NEXT:       parameter x : float
