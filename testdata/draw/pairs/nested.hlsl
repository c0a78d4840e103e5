// A struct in a struct.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
struct Surface { float3 normal : NORMAL; float2 uv : TEXCOORD0; };
struct Varyings { float4 position : SV_Position; Surface surface; float4 color : COLOR; };
Varyings vs(float4 p : POSITION, Surface s, float4 c : COLOR) {
  Varyings v;
  v.position = p;
  v.surface = s;
  v.color = c;
  return v;
}
float4 ps(Varyings v) : SV_Target { return float4(v.surface.normal, v.surface.uv.x) * v.color; }
