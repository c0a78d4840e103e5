// The pixel shader reads its place on the screen and which side it is of.
// The reference compilers keep the origin and the w of GLSL, so their image is not that of two halves of clipc's.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --forms glsl,spirv,hlsl
struct Varyings { float4 position : SV_Position; float4 color : COLOR; };
Varyings vs(float4 p : POSITION, float4 c : COLOR) {
  Varyings v;
  v.position = p;
  v.color = c;
  return v;
}
float4 ps(Varyings v, bool is_front : SV_IsFrontFace) : SV_Target { return v.color * v.position.xyxy / (is_front ? 64 : 32); }
