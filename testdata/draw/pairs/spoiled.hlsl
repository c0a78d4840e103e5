// A location, a member or a name that is another one gives another picture, or a program that does not link.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --targets glsl450,essl310 --spoil "v_uv = =v_uv = 1.01 * "
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --targets glsl450,essl310 --forms glsl --spoil "location = 0) out=location = 3) out"
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --targets glsl330,essl300 --forms glsl --spoil "out vec4 v_uv=out vec4 v_uv2; out vec4 v_uvs"
cbuffer Frame : register(b0) { float4x4 view; float4 tint; float4 shade; };
struct Varyings { float4 position : SV_Position; float4 uv : TEXCOORD0; };
Varyings vs(float4 p : POSITION, float4 uv : TEXCOORD0) {
  Varyings v;
  v.position = mul(p, view);
  v.uv = uv * tint;
  return v;
}
float4 ps(Varyings v) : SV_Target { return v.uv * shade; }
