// Direct3D 9's `sampler` has the kind that reads it, also where a function, a struct or a uniform parameter of the entry point hands it on.
// An index of an array of textures that a `static const` variable names is constant.
// RUN: %clipc -T ps_3_0 %s --target=vulkan --validate -o - | FileCheck %s --check-prefixes=CHECK,VULKAN
// RUN: %clipc -T ps_3_0 %s --target=glsl330 --validate -o - | FileCheck %s --check-prefixes=CHECK,GL
// RUN: %clipc -T ps_5_0 -E indexed %s --target=glsl330 --validate -o - | FileCheck %s --check-prefix=INDEX
sampler Flat : register(s0);
sampler Round : register(s1);
struct Material { sampler Map; float Scale; };
Material Skin;
float4 Read(sampler s, float2 uv) { return tex2D(s, uv); }
float4 ReadCube(sampler s, float3 v) { return texCUBE(s, v); }
float4 main(float4 uv : TEXCOORD0, uniform sampler Last) : COLOR {
  Material m = Skin;
  return Read(Flat, uv.xy) + ReadCube(Round, uv.xyz) + tex2D(m.Map, uv.zw) * m.Scale + Read(Last, uv.yz);
}
// CHECK-DAG: uniform sampler2D Flat;
// CHECK-DAG: uniform samplerCube Round;
// CHECK-DAG: uniform sampler2D Skin_Map;
// CHECK-DAG: uniform sampler2D Last;
// VULKAN: void main() {
// GL: void main() {
Texture2D Maps[2];
SamplerState Taps;
static const uint kSecond = 1;
float4 Tap(Texture2D map, float2 uv) { return map.Sample(Taps, uv); }
float4 indexed(float2 uv : TEXCOORD0) : SV_Target { return Tap(Maps[kSecond], uv); }
// INDEX: return texture(Maps[1], uv);
// RUN: %draw compare %s -T ps_3_0
