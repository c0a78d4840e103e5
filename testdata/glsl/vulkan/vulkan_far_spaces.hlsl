// glslang takes sets up to 62 (layoutSetEnd): a space above is the lowest set that no other space has, with a warning, and the reflection
// lists it. What the user fixes by [[vk::binding]] or by options for bindings is an error: check/registers/fail_vulkan.hlsl.
// RUN: %clipc -T vs_5_1 --target=vulkan --validate %s -o %t.vert --reflect=%t.json 2>&1 | FileCheck %s --check-prefix=WARNING --implicit-check-not=warning
// RUN: FileCheck %s --input-file %t.vert
// WARNING: [[#@LINE+1]]:11: warning: `maps` is in space 100; the highest set is 62,
Texture2D maps[] : register(t0, space100);
SamplerState taps : register(s0, space100);
// WARNING: [[#@LINE+1]]:9: warning: `frame` is in space 4294967040; the highest set is 62, so its set is the first that no other space has, as `--reflect` lists; {{.*}} names one [-Wtarget-set-renumbered]
cbuffer frame : register(b3, space4294967040) { float4 scale; };
Texture2D plain : register(t0);
Texture2D near : register(t0, space2);
float4 main(uint i : I) : SV_Position {
  // WARNING: [[#@LINE+1]]:15: warning: the index of `maps` may differ between the vertices of a draw call
  return maps[i].SampleLevel(taps, scale.xy, 0) + plain.Load(int3(0, 0, 0)) + near.Load(int3(0, 0, 0));
}
// CHECK-DAG: layout(std140, set = 3, binding = 3) uniform frame {  // b3, space4294967040
// CHECK-DAG: layout(set = 1, binding = 32) uniform texture2D maps[];  // t0
// CHECK-DAG: layout(set = 1, binding = 16) uniform sampler taps;  // s0
// CHECK-DAG: layout(set = 0, binding = 32) uniform texture2D plain;  // t0
// CHECK-DAG: layout(set = 2, binding = 32) uniform texture2D near;  // t0
// RUN: FileCheck %s --check-prefix=JSON --input-file %t.json
// JSON: "space": 4294967040,
// JSON: "set": 3,
// JSON-NEXT: "binding": 3
