// What must hold around the attribute, each with its message.
// RUN: not %clipc -T vs_5_0 -E none %s 2>&1 | FileCheck %s --check-prefix=NONE
// RUN: not %clipc -T vs_5_0 -E empty %s 2>&1 | FileCheck %s --check-prefix=EMPTY
// RUN: not %clipc -T vs_5_0 -E seven %s 2>&1 | FileCheck %s --check-prefix=SEVEN
// RUN: not %clipc -T vs_5_0 -E twice %s 2>&1 | FileCheck %s --check-prefix=TWICE
// RUN: not %clipc -T vs_5_0 -E disagree %s 2>&1 | FileCheck %s --check-prefix=DISAGREE
// RUN: not %clipc -T vs_5_0 -E by_hand %s 2>&1 | FileCheck %s --check-prefix=HAND
// RUN: not %clipc -T vs_5_0 -E no_position %s 2>&1 | FileCheck %s --check-prefix=NOPOSITION
// RUN: not %clipc -T vs_5_0 -E position3 %s 2>&1 | FileCheck %s --check-prefix=POSITION3
// RUN: not %clipc -T vs_3_0 -E one %s 2>&1 | FileCheck %s --check-prefix=VS3
// RUN: not %clipc -T ps_5_0 -E one %s 2>&1 | FileCheck %s --check-prefix=PS
cbuffer Planes { float4 p, q; };

[clipplanes(p)] float4 one(float4 v : POSITION) : SV_Position { return v; }
// VS3: error: `clipplanes` is used under profile `vs_3_0`; it needs a vertex shader profile of 4.0 or later; `-T vs_4_0_level_9_1` is for the same hardware [clip-planes-profile]
// PS: error: {{.*}}ps_5_0

// NONE: fail_situations.hlsl:[[#@LINE+1]]:1: error: 0 clip planes given; `clipplanes` takes 1 to 6 [clip-plane-count, X3084]
[clipplanes] float4 none(float4 v : POSITION) : SV_Position { return v; }
// EMPTY: fail_situations.hlsl:[[#@LINE+1]]:1: error: 0 clip planes given; `clipplanes` takes 1 to 6 [clip-plane-count, X3084]
[clipplanes()] float4 empty(float4 v : POSITION) : SV_Position { return v; }
// SEVEN: fail_situations.hlsl:[[#@LINE+1]]:31: error: 7 clip planes given; `clipplanes` takes 1 to 6 [clip-plane-count, X3084]
[clipplanes(p, q, p, q, p, q, p)] float4 seven(float4 v : POSITION) : SV_Position { return v; }

// TWICE: fail_situations.hlsl:[[#@LINE+2]]:17: error: `clipplanes` is given twice; give all planes in one attribute [clip-planes-twice, X3524]
// TWICE: fail_situations.hlsl:[[#@LINE+1]]:1: note: first given here
[clipplanes(p)] [clipplanes(q)] float4 twice(float4 v : POSITION) : SV_Position { return v; }

[clipplanes(p)] float4 disagree(float4 v : POSITION) : SV_Position;
// DISAGREE: error: the clip planes of the definition differ from those of the prototype; they must be the same, or given once [clip-planes-disagree, X3524]
[clipplanes(q)] float4 disagree(float4 v : POSITION) : SV_Position { return v; }

struct WithDistance {
  float4 position : SV_Position;
  // HAND: fail_situations.hlsl:[[#@LINE+3]]:1: error: `clipplanes` on a shader that also writes SV_ClipDistance; use one or the other [clip-planes-with-clip-distance, X3536]
  // HAND: fail_situations.hlsl:[[#@LINE+1]]:20: note: clip distances are written here
  float distance : SV_ClipDistance; };
[clipplanes(p)] WithDistance by_hand(float4 v : POSITION) { WithDistance o; o.position = v; o.distance = 1; return o; }

// NOPOSITION: fail_situations.hlsl:[[#@LINE+1]]:1: error: `clipplanes` on a shader without an SV_Position output; the planes clip against the position [clip-planes-without-position]
[clipplanes(p)] float4 no_position(float4 v : POSITION) : POSITION { return v; }
// POSITION3: error: `SV_Position` has type `float3`; it must be a `float4` [semantic-type, X4503]
[clipplanes(p)] float3 position3(float3 v : POSITION) : SV_Position { return v; }
