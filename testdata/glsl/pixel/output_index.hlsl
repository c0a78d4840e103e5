// A component of a color that an index chooses: OpenGL ES compilers refuse it of an output, so a variable is written at the end.
// RUN: %clipc %s -T ps_5_0 -E local --target=webgl2 --validate -o - | FileCheck %s --check-prefix=LOCAL
// RUN: %clipc %s -T ps_5_0 -E local --target=glsl450 --validate -o - | FileCheck %s --check-prefix=DESKTOP
// RUN: %clipc %s -T ps_5_0 -E literal --target=essl300 --validate -o - | FileCheck %s --check-prefix=LITERAL
// RUN: %clipc %s -T ps_5_0 -E parameter --target=essl310 --validate -o - | FileCheck %s --check-prefix=PARAMETER
// RUN: %clipc %s -T ps_5_0 -E member --target=essl320 --validate -o - | FileCheck %s --check-prefix=MEMBER
// RUN: %clipc %s -T ps_5_0 -E written --target=essl300 --validate -o %t.frag
// RUN: %draw compare %s -T ps_5_0 -E local --target essl300,essl310,essl320,essl100,glsl450
// RUN: %draw compare %s -T ps_5_0 -E parameter --target essl300,essl320,glsl450
// RUN: %draw compare %s -T ps_5_0 -E member --target essl300,essl320,glsl450
// RUN: %draw compare %s -T ps_5_0 -E written --target essl300,essl320,glsl450
// LOCAL: void main() {
// LOCAL-NEXT: vec4 [[C:SV_Target0_2]];
// LOCAL: [[C]][i] = [[C]][i] * [[C]][i];
// LOCAL: SV_Target0 = [[C]];
// DESKTOP: SV_Target0[i] = SV_Target0[i] * SV_Target0[i];
float4 local(float4 p : T) : SV_Target {
  float4 c = p;
  for (int i = 0; i < 3; i++) c[i] = c[i] * c[i];
  return c;
}
// LITERAL-NOT: SV_Target0_2
float4 literal(float4 p : T) : SV_Target {
  float4 c = p;
  c[1] += 5;
  return c;
}
// PARAMETER: SV_Target0_2[i] += vs_T0[i] + 5.0;
void parameter(float4 p : T, out float4 o : SV_Target) {
  o = 0;
  for (int i = 0; i < 4; i++) o[i] += p[i] + 5;
}
struct Colors {
  float4 color : SV_Target0;
  uint4 bits : SV_Target1;
  float2 plain : SV_Target2;
};
// MEMBER: SV_Target0 = SV_Target0_2;
// MEMBER-NEXT: SV_Target1 = SV_Target1_2;
// MEMBER-NOT: SV_Target2_2
Colors member(float4 p : T) {
  Colors o;
  o.color = p;
  o.bits = 0;
  o.plain = p.xy;
  for (uint i = 0; i < 4; i++) {
    o.color[i] *= 2;
    o.bits[i] |= i + 1;
    o.bits[3 - i]++;
  }
  return o;
}
void Set(out float x, float y) { x = y; }
float4 written(float4 p : T) : SV_Target {
  float4 c = p;
  for (int i = 0; i < 4; i++) Set(c[i], p[3 - i]);
  return c;
}
