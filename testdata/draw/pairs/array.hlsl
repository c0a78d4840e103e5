// An array between the shaders.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
struct Varyings { float4 position : SV_Position; float2 uv[3] : TEXCOORD0; float4 color : COLOR; };
Varyings vs(float4 p : POSITION, float2 uv : TEXCOORD0, float4 c : COLOR) {
  Varyings v;
  v.position = p;
  for (int i = 0; i < 3; ++i) v.uv[i] = uv * (i + 1);
  v.color = c;
  return v;
}
float4 ps(Varyings v) : SV_Target { return v.color * v.uv[0].x + v.uv[1].xyxy * v.uv[2].yxxy; }
