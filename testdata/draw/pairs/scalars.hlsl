// Scalars and vectors of all sizes.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
struct Varyings { float4 position : SV_Position; float a : A; float2 b : B; float3 c : C; float4 d : D; };
Varyings vs(float4 p : POSITION, float a : A, float2 b : B, float3 c : C, float4 d : D) {
  Varyings v;
  v.position = p;
  v.a = a;
  v.b = b;
  v.c = c;
  v.d = d;
  return v;
}
float4 ps(Varyings v) : SV_Target { return v.a * float4(v.c, 1) + v.b.xyxy * v.d; }
