// fxc refuses an input or output without a semantic (X3502); Slang names it after itself, and so do we, with a warning.
// RUN: %clipc -T vs_5_0 -E main --validate %s -o - 2>&1 | FileCheck %s
// RUN: %clipc -T vs_5_0 -E newer --target=vulkan --validate %s -o - 2>&1 | FileCheck %s --check-prefix=NEWER
struct Input { float4 position : POSITION; float4 uv2; };
// CHECK: warning: `input.uv2` has no semantic; clipc assumes `uv2`, fxc reports an error [-Wsemantic-missing]
// CHECK: in vec4 in_UV2;
float4 main(Input input) : SV_Position { return input.position + input.uv2; }
// NEWER: warning: `SV_ViewID` needs profile vs_6_1; this is `vs_5_0` [-Wprofile-needed-for-semantic]
float4 newer(float4 v : POSITION, uint view : SV_ViewID) : SV_Position { return v * view; }
// All that have none are one warning.
// RUN: %clipc -T vs_5_0 -E several %s -o - 2>&1 | FileCheck %s --check-prefix=SEVERAL --implicit-check-not=warning
struct Slang { float4 place; float2 uv; };
// SEVERAL: [[#@LINE-1]]:23: warning: `v.place` has no semantic; clipc assumes `place0`, fxc reports an error [-Wsemantic-missing]
// SEVERAL: [[#@LINE-2]]:37: note: `v.uv` has none either; clipc assumes `uv0`
// SEVERAL: [[#@LINE+1]]:29: note: `number` has none either; clipc assumes `number0`
float4 several(Slang v, int number) : SV_Position { return v.place + v.uv.xyxy + number; }
