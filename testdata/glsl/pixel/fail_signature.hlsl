// The words for what a pixel shader may not do.
// RUN: not %clipc -T ps_5_0 -E outputs %s -o - 2>&1 | FileCheck %s --check-prefix=OUTPUTS
// RUN: not %clipc -T ps_5_0 -E twice %s -o - 2>&1 | FileCheck %s --check-prefix=TWICE
// RUN: not %clipc -T ps_3_0 -E position %s -o - 2>&1 | FileCheck %s --check-prefix=POSITION
// RUN: not %clipc -T ps_5_0 -E planes %s -o - 2>&1 | FileCheck %s --check-prefix=PLANES
// RUN: not %clipc -T ps_5_0 -E dual %s -o - 2>&1 | FileCheck %s --check-prefix=DUAL
// RUN: not %clipc -T ps_5_0 -E indexed --target=essl100 %s -o - 2>&1 | FileCheck %s --check-prefix=INDEXED
// RUN: not %clipc -T ps_5_0 -E good --lower=discard --plane-space=xyw1 --invariant --pixel-shader=%s %s -o - 2>&1 | FileCheck %s --check-prefix=OPTIONS
cbuffer C { float4 plane; float4 colors[4]; };

void outputs(out float4 a : SV_Target8, out float4 b : TEXCOORD0, out float4 c : SV_Position) { a = b = c = 0; }
// OUTPUTS: [[#@LINE-1]]:29: error: `SV_Target8` is not a render target; the last is number 7 [too-many-targets, X4502]
// OUTPUTS: [[#@LINE-2]]:56: error: `TEXCOORD` is not an output of a pixel shader
// OUTPUTS: [[#@LINE-3]]:82: error: `SV_Position` is not an output of a pixel shader

void twice(out float4 a : SV_Target1, out float4 b : COLOR1) { a = b = 0; }
// TWICE: error: semantic `SV_TARGET1` is used twice among the outputs

float4 position(float4 p : POSITION) : COLOR { return p; }
// POSITION: [[#@LINE-1]]:28: error: `POSITION` is read; profile `ps_3_0` has no such input of a pixel shader [profile-input, X4502]

[clipplanes(plane)] float4 planes(float4 c : COLOR) : SV_Target { return c; }
// PLANES: [[#@LINE-1]]:1: error: `clipplanes` is used under profile `ps_5_0`; it needs a vertex shader profile of 4.0 or later [clip-planes-profile]

struct Dual {
  [[vk::location(0), vk::index(1)]] float4 a : SV_Target0;
  [[vk::location(0), vk::index(1)]] float4 b : SV_Target1;
};
Dual dual() { return (Dual)0; }
// DUAL: error: location 0 of `dual.b` is that of `dual.a` too [location-twice]

float4 indexed(float2 uv : UV) : SV_Target { return colors[int(uv.x)]; }
// INDEXED: error: the index of `colors` is not constant; a fragment shader of target `essl100` indexes uniforms by constants and by the indices of loops only [target-uniform-index]

float4 good() : SV_Target { return 0; }
// OPTIONS-DAG: error: `--pixel-shader` is about a vertex shader; profile `ps_5_0` is of a pixel shader [option-of-stage]
// OPTIONS-DAG: error: `--lower` is about a vertex shader; profile `ps_5_0` is of a pixel shader [option-of-stage]
// OPTIONS-DAG: error: `--plane-space` is about a vertex shader
// OPTIONS-DAG: error: `--invariant` is about a vertex shader
