// A location, a member, a binding or a name that is another one, or a value a little off, gives another image, a program that does
// not link, or a message of Vulkan's validation layers.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --spoil "v_uv = =>v_uv = 1.01 * "
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --spoil "vec4 tint;\n    vec4 shade;=>vec4 shade;\n    vec4 tint;"
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --targets glsl450,essl310,vulkan --spoil "location = 0) out=>location = 3) out"
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --targets glsl330,essl300 --forms glsl --spoil "out vec4 v_uv;=>out vec4 v_uv2; vec4 v_uv;"
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --targets vulkan --spoil "binding = 0)=>binding = 3)"
cbuffer Frame : register(b0) { float4x4 view; float4 tint; float4 shade; };
struct Varyings { float4 position : SV_Position; float4 uv : TEXCOORD0; };
Varyings vs(float4 p : POSITION, float4 uv : TEXCOORD0) {
  Varyings v;
  v.position = mul(p, view);
  v.uv = uv * tint;
  return v;
}
float4 ps(Varyings v) : SV_Target { return v.uv * shade; }
