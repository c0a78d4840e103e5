// What names the position: SV_Position; POSITION before 4.0 and, with -Gec, after it.
// RUN: not %clipc -T vs_5_0 -E main -Ges %s -o - 2>&1 | FileCheck %s --check-prefix=STRICT
// RUN: %clipc -T vs_5_0 -E main %s -o - 2>&1 | FileCheck %s --check-prefix=PLAIN
// RUN: %clipc -T vs_4_0_level_9_1 -E main %s -o - 2>&1 | FileCheck %s --check-prefix=PLAIN
// RUN: %clipc -T vs_5_0 -E main -Gec %s -o - 2>&1 | FileCheck %s --check-prefix=BOTH
// RUN: %clipc -T vs_3_0 -E main %s -o - 2>&1 | FileCheck %s --check-prefix=BOTH
// RUN: %clipc -T vs_5_0 -E both %s -o - 2>&1 | FileCheck %s --check-prefix=TWO
// RUN: not %clipc -T vs_5_0 -E both -Gec %s -o - 2>&1 | FileCheck %s --check-prefix=TWICE
// RUN: not %clipc -T vs_5_0 -E planes %s -o - 2>&1 | FileCheck %s --check-prefix=PLANES
// RUN: %clipc -T vs_5_0 -E planes -Gec %s -o - 2>&1 | FileCheck %s --check-prefix=CLIPPED
// RUN: not %clipc -Gec -Ges %s 2>&1 | FileCheck %s --check-prefix=CONTRADICTION
// RUN: %draw compare %s -T vs_3_0 -E main
cbuffer Planes { float4 p; };

// PLAIN: fail_position_name.hlsl:[[#@LINE+4]]:36: warning: `POSITION` is an output like any other under `vs_{{[^`]*}}`, and nothing is the position; write `SV_Position`, or use `-Gec`, which accepts Direct3D 9's names [-Wposition-is-plain]
// PLAIN: vs_POSITION0 =
// BOTH-NOT: warning:
// STRICT: :[[#@LINE+1]]:36: error: `POSITION` is Direct3D 9's name of the position; `-Ges` accepts only `SV_Position` [position-refused]
float4 main(float4 v : POSITION) : POSITION { return v; }
// BOTH: gl_Position = in_POSITION0;

struct Both {
  float4 system : SV_Position;
  float4 plain : Position0;
};
// TWO-NOT: warning:
// TWO: vs_POSITION0 =
// TWICE: error: semantic `SV_POSITION0` is used twice among the outputs; each index of a semantic may be used once
Both both(float4 v : POSITION) {
  Both o;
  o.system = v;
  o.plain = v;
  return o;
}

// PLANES: :[[#@LINE+3]]:1: error: `clipplanes` on a shader without an SV_Position output; the planes clip against the position [clip-planes-without-position]
// PLANES: :[[#@LINE+3]]:38: note: `POSITION` is written here
// CLIPPED: gl_ClipDistance[0] = dot(
[clipplanes(p)]
float4 planes(float4 v : POSITION) : POSITION { return v; }
// CONTRADICTION: -Gec and -Ges contradict each other
