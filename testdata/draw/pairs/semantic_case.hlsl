// Semantics without an index, with one, and in other letters.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --reference reference
struct Varyings { float4 position : SV_POSITION; float2 a : texcoord; float2 b : TexCoord1; float4 color : color0; };
Varyings vs(float4 p : POSITION, float2 uv : TEXCOORD0, float4 c : COLOR) {
  Varyings v;
  v.position = p;
  v.a = uv;
  v.b = uv.yx * 2;
  v.color = c;
  return v;
}
struct Read { float4 position : SV_Position; float4 color : COLOR; float2 b : TEXCOORD1; float2 a : TEXCOORD0; };
Read reference(float4 p : POSITION, float2 uv : TEXCOORD0, float4 c : COLOR) {
  Read v;
  v.position = p;
  v.a = uv;
  v.b = uv.yx * 2;
  v.color = c;
  return v;
}
float4 ps(Read v) : SV_Target { return v.color + v.b.xyxy * v.a.yyxx; }
