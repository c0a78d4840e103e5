// Code on both sides.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
cbuffer Frame : register(b0) { float4x4 view; float4 lights[3]; };
struct Varyings { float4 position : SV_Position; float4 color : COLOR; float3 normal : NORMAL; };
float3 Light(float3 n, int count) {
  float3 sum = 0;
  [loop] for (int i = 0; i < count; ++i) sum += saturate(dot(n, lights[i].xyz)) * lights[i].w;
  return sum;
}
Varyings vs(float4 p : POSITION, float4 c : COLOR, float3 n : NORMAL) {
  Varyings v;
  v.position = mul(p, view);
  v.color = c + float4(Light(n, 3), 0);
  v.normal = normalize(n + 0.1);
  return v;
}
float4 ps(Varyings v) : SV_Target { return v.color * float4(Light(v.normal, 2), 1); }
