// Textures, samplers and buffers are global variables; GLSL cannot keep or choose one.
// RUN: not %clipc -E member %s 2>&1 | FileCheck %s
// CHECK: error: a `Texture2D<float4>` is a parameter, a member of a struct or a local; clipc takes textures, samplers and buffers only as global variables
Texture2D t, u;
SamplerState s;
struct Material { Texture2D color; };
float4 FromMaterial(Material m, float2 uv) { return m.color.SampleLevel(s, uv, 0); }
Material material;
float4 member(float4 v : POSITION) : SV_Position { return FromMaterial(material, v.xy); }
