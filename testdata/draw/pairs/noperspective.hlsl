// Linear on the screen, at the centroid, and neither.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --targets glsl450,glsl330,vulkan
cbuffer Frame { float4 plane; };
struct Varyings { float4 position : SV_Position; noperspective float2 a : A; centroid float2 b : B; float2 c : C; };
Varyings vs(float4 p : POSITION, float2 uv : TEXCOORD0) {
  Varyings v;
  v.position = p * (1 + uv.x + plane.x);
  v.a = uv;
  v.b = uv.yx;
  v.c = uv * 2;
  return v;
}
float4 ps(Varyings v) : SV_Target { return float4(v.a * v.b, v.c); }
