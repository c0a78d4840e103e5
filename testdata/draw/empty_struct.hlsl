// A struct without members takes no room in a buffer; GLSL has no such struct.
// RUN: %draw compare %s -T vs_5_0 -E main --lower none
struct Nothing {};
struct Outer {
  Nothing inside;
};
cbuffer First : register(b0) {
  Outer none;
  float4 foo;
};
cbuffer Second : register(b1) {
  Outer nones[2];
  float4 bar;
};
float4 Pass(Outer outer, float4 value) { return value; }
float4 main(float4 p : POSITION) : SV_Position { return Pass(none, foo) + bar * p; }
