// What pixel shaders of level 9 lack. Oracles: "Shader model 4 level 9_x" and the feature levels' table of Microsoft's reference (render
// targets); ps_4_0_level_9_1 runs as ps_2_0, which has no flow control, no integers, no gradients and no texldl ("ps_2_0 instructions"
// of the Direct3D 9 reference); fxc X4532, "cannot map expression to ps_2_0 instruction set", and X3511.
// RUN: not %clipc -T ps_4_0_level_9_1 -E position %s -o - 2>&1 | FileCheck %s --check-prefix=POSITION
// RUN: not %clipc -T ps_4_0_level_9_3 -E face %s -o - 2>&1 | FileCheck %s --check-prefix=FACE
// RUN: not %clipc -T ps_4_0_level_9_3 -E level %s -o - 2>&1 | FileCheck %s --check-prefix=LEVEL
// RUN: not %clipc -T ps_4_0_level_9_3 -E load %s -o - 2>&1 | FileCheck %s --check-prefix=LEVEL
// RUN: not %clipc -T ps_4_0_level_9_1 -E graded %s -o - 2>&1 | FileCheck %s --check-prefix=LEVEL
// RUN: %clipc -T ps_4_0_level_9_3 -E graded %s -o %t
// RUN: not %clipc -T ps_4_0_level_9_3 -E loop %s -o - 2>&1 | FileCheck %s --check-prefix=LOOP
// RUN: not %clipc -T ps_4_0_level_9_3 -E bits %s -o - 2>&1 | FileCheck %s --check-prefix=BITS
// RUN: not %clipc -T ps_4_0_level_9_3 -E as_int %s -o - 2>&1 | FileCheck %s --check-prefix=ASINT
// RUN: not %clipc -T ps_4_0_level_9_1 -E slope %s -o - 2>&1 | FileCheck %s --check-prefix=SLOPE
// RUN: %clipc -T ps_4_0_level_9_3 -E slope %s -o %t
// RUN: not %clipc -T ps_4_0_level_9_1 -E two %s -o - 2>&1 | FileCheck %s --check-prefix=TWO
// RUN: %clipc -T ps_4_0_level_9_3 -E two %s -o %t
// RUN: not %clipc -T ps_4_0_level_9_3 -E five %s -o - 2>&1 | FileCheck %s --check-prefix=FIVE
// RUN: %clipc -T ps_4_0_level_9_1 -E plain %s -o - 2>&1 | FileCheck %s --check-prefix=PLAIN
Texture2D map;
SamplerState s;
int count;
// POSITION: error: `SV_Position` is read; profile `ps_4_0_level_9_1` has no such input of a pixel shader [profile-input, X4502]
float4 position(float4 p : SV_Position) : SV_Target { return p; }
// FACE: error: `SV_IsFrontFace` is read; profile `ps_4_0_level_9_3` has no such input
float4 face(bool is_front : SV_IsFrontFace) : SV_Target { return is_front; }
// LEVEL: error: a texture is read in a way that `ps_4_0_level_9_{{.}}` lacks; it has `Sample`, `SampleBias`, `SampleCmp`, and from 9_3 on `SampleGrad` [level9-sample, X4532]
float4 level(float2 t : T) : SV_Target { return map.SampleLevel(s, t, 0); }
float4 load(float2 t : T) : SV_Target { return map.Load(int3(t, 0)); }
float4 graded(float2 t : T) : SV_Target { return map.SampleGrad(s, t, t, t); }
float4 loop(float2 t : T) : SV_Target {
  float4 r = 0;
  // LOOP: [[#@LINE+1]]:19: error: only the running shader knows how often the loop runs; `ps_4_0_level_9_3` has no such loops [level9-unknown-loop, X3511]
  for (int i = 0; i < count; ++i) r += t.x;
  for (int k = 0; k < 4; ++k) r += t.y;
  return r;
}
// BITS: error: a bit operation is used; `ps_4_0_level_9_3` has no integer instructions [level9-bit-operation, X3535]
float4 bits(float2 t : T) : SV_Target { return count & 3; }
// ASINT: error: `asint` works with the bits of integers; `ps_4_0_level_9_3` has no integer instructions [level9-intrinsic, X4583]
float4 as_int(float2 t : T) : SV_Target { return asint(t.x); }
// SLOPE: error: `ddx` needs profile ps_4_0_level_9_3 or later; this is `ps_4_0_level_9_1` [intrinsic-profile, X4532]
float4 slope(float2 t : T) : SV_Target { return ddx(t.x); }
struct Two { float4 c[2] : SV_Target; };
struct Five { float4 c[5] : SV_Target; };
// TWO: error: `SV_Target1` is not a render target; the last is number 0 [too-many-targets, X4502]
Two two(float2 t : T) { return (Two)1; }
// FIVE: error: `SV_Target4` is not a render target; the last is number 3
Five five(float2 t : T) { return (Five)1; }
// A position that is declared and not read is left out.
// PLAIN-NOT: {{error|warning}}:
// PLAIN: SV_Target0 = texture(map, vs_T0);
float4 plain(float4 p : SV_Position, float2 t : T) : SV_Target { return map.Sample(s, t); }
