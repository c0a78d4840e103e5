// What pixel shaders of Direct3D 9 lack. Oracles: "ps_2_0" and "ps_3_0 registers" of the Direct3D 9 reference: v0, v1, t0 to t7, s0 to
// s15, four targets, no flow control before ps_3_0; D3DXGetPixelShaderProfile, which gives ps_2_a alone gradients and no 2_x profile
// flow control; fxc X4502, "invalid ps_2_0 input semantic"; X3511; X4567.
// RUN: not %clipc -T ps_2_0 -E normal %s -o - 2>&1 | FileCheck %s --check-prefix=NORMAL
// RUN: %clipc -T ps_3_0 -E normal %s -o %t
// RUN: not %clipc -T ps_2_a -E corner %s -o - 2>&1 | FileCheck %s --check-prefix=CORNER
// RUN: not %clipc -T ps_2_0 -E side %s -o - 2>&1 | FileCheck %s --check-prefix=SIDE
// RUN: not %clipc -T ps_2_a -E ninth %s -o - 2>&1 | FileCheck %s --check-prefix=NINTH
// RUN: not %clipc -T ps_2_b -E third %s -o - 2>&1 | FileCheck %s --check-prefix=THIRD
// RUN: %clipc -T ps_2_0 -E carried %s -o - 2>&1 | FileCheck %s --check-prefix=CARRIED
// RUN: not %clipc -T ps_2_0 -E loop %s -o - 2>&1 | FileCheck %s --check-prefix=LOOP
// RUN: not %clipc -T ps_2_a -E loop %s -o - 2>&1 | FileCheck %s --check-prefix=LOOP
// RUN: %clipc -T ps_3_0 -E loop %s -o %t
// RUN: not %clipc -T ps_2_0 -E graded %s -o - 2>&1 | FileCheck %s --check-prefix=GRADED
// RUN: %clipc -T ps_2_a -E graded %s -o %t
// RUN: not %clipc -T ps_2_0 -E level %s -o - 2>&1 | FileCheck %s --check-prefix=LEVEL
// RUN: not %clipc -T ps_3_0 -E far %s -o - 2>&1 | FileCheck %s --check-prefix=FAR
// RUN: not %clipc -T ps_3_0 -E five %s -o - 2>&1 | FileCheck %s --check-prefix=FIVE
// RUN: not %clipc -T ps_3_0 -E planes %s -o - 2>&1 | FileCheck %s --check-prefix=PLANES
sampler2D map;
sampler2D sixteen : register(s16);
int count;
float4 plane;
// NORMAL: error: `NORMAL` is read; profile `ps_2_0` has no such input of a pixel shader [profile-input, X4502]
float4 normal(float3 n : NORMAL) : COLOR { return n.xyzx; }
// CORNER: error: `VPOS` is read; profile `ps_2_a` has no such input of a pixel shader [profile-input, X4502]
float4 corner(float2 p : VPOS) : COLOR { return p.xyxy; }
// SIDE: error: `VFACE` is read; profile `ps_2_0` has no such input
float4 side(float f : VFACE) : COLOR { return f; }
// NINTH: error: `TEXCOORD` is read; profile `ps_2_a` has no such input
float4 ninth(float4 t : TEXCOORD8) : COLOR { return t; }
// THIRD: error: `COLOR` is read; profile `ps_2_b` has no such input
float4 third(float4 t : COLOR2) : COLOR { return t; }
// What is declared and not read needs no register.
// CARRIED-NOT: {{error|warning}}:
// CARRIED: SV_Target0 = vec4(1.0);
float4 carried(float3 n : NORMAL, float4 p : POSITION) : COLOR { return 1; }
float4 loop(float2 t : TEXCOORD0) : COLOR {
  float4 r = 0;
  // LOOP: [[#@LINE+1]]:19: error: only the running shader knows how often the loop runs; `ps_2_{{.}}` has no such loops [level9-unknown-loop, X3511]
  for (int i = 0; i < count; ++i) r += t.x;
  return r;
}
// GRADED: error: `tex2Dgrad` needs profile ps_2_a or ps_3_0 or later; this is `ps_2_0` [intrinsic-profile, X4532]
float4 graded(float2 t : TEXCOORD0) : COLOR { return tex2Dgrad(map, t, t, t); }
// LEVEL: error: `tex2Dlod` needs profile ps_3_0 or later; this is `ps_2_0` [intrinsic-profile, X4532]
float4 level(float4 t : TEXCOORD0) : COLOR { return tex2Dlod(map, t); }
// FAR: error: register s16 of `sixteen` is too high; the highest under this profile is 15 [register-too-high, X4567]
float4 far(float2 t : TEXCOORD0) : COLOR { return tex2D(sixteen, t); }
struct Five { float4 c[5] : COLOR; };
// FIVE: error: `COLOR4` is not a render target; the last is number 3 [too-many-targets, X4502]
Five five() { return (Five)1; }
// PLANES: error: `clipplanes` is used under profile `ps_3_0`; it needs a vertex shader profile of 4.0 or later [clip-planes-profile]
[clipplanes(plane)] float4 planes() : COLOR { return 1; }
