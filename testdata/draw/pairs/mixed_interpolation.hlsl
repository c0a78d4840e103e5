// The pixel shader says how it interpolates; the vertex shader does not.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --reference reference
struct Varyings { float4 position : SV_Position; float4 a : A; float4 b : B; };
Varyings vs(float4 p : POSITION, float4 a : A, float4 b : B) {
  Varyings v;
  v.position = p;
  v.a = a;
  v.b = b;
  return v;
}
struct Read { float4 position : SV_Position; nointerpolation float4 a : A; centroid float4 b : B; };
Read reference(float4 p : POSITION, float4 a : A, float4 b : B) {
  Read v;
  v.position = p;
  v.a = a;
  v.b = b;
  return v;
}
float4 ps(Read v) : SV_Target { return v.a * 0.5 + v.b; }
