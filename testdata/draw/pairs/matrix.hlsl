// A matrix between the shaders.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
struct Varyings { float4 position : SV_Position; float3x3 tangents : TANGENTS; float4 color : COLOR; };
Varyings vs(float4 p : POSITION, float3 n : NORMAL, float3 t : TANGENT, float4 c : COLOR) {
  Varyings v;
  v.position = p;
  v.tangents = float3x3(n, t, cross(n, t));
  v.color = c;
  return v;
}
float4 ps(Varyings v) : SV_Target { return float4(mul(v.color.xyz, v.tangents), v.tangents[1][2]); }
