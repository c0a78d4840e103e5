// RUN: not %clipc -E parameter %s 2>&1 | FileCheck %s
// RUN: not %clipc -E member %s 2>&1 | FileCheck %s
// CHECK: error: a `Texture2D<float4>` is a parameter or a member of a struct; clipc takes textures, samplers and buffers only as global variables
Texture2D t;
SamplerState s;
float4 Read(Texture2D from, float2 uv) { return from.SampleLevel(s, uv, 0); }
float4 parameter(float4 v : POSITION) : SV_Position { return Read(t, v.xy); }
struct Material { Texture2D color; };
float4 FromMaterial(Material m, float2 uv) { return m.color.SampleLevel(s, uv, 0); }
Material material;
float4 member(float4 v : POSITION) : SV_Position { return FromMaterial(material, v.xy); }
