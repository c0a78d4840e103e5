// A clipped shader, of whose image the plane cuts nothing off: the reference compilers lose it.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --targets glsl450,glsl330,vulkan
cbuffer Frame : register(b0) { float4 planes[4]; };
struct Varyings { float4 position : SV_Position; float3 world : WORLD; float4 color : COLOR; };
[clipplanes(planes[3])]
Varyings vs(float4 p : POSITION, float4 c : COLOR) {
  Varyings v;
  v.position = p;
  v.world = p.xyz * 2;
  v.color = c;
  return v;
}
float4 ps(Varyings v) : SV_Target { return v.color * float4(v.world, dot(v.world, planes[3].xyz)); }
