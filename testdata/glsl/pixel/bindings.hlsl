// A pixel shader that is compiled alone has numbers of its own, so that a vertex shader of another run does not bind them: Direct3D has
// t0 and b0 in each stage. On Vulkan all are higher by 256, on OpenGL the units of textures by 16; a block of OpenGL has its register in
// both stages, as all blocks of one name in a program have one number (GLSL 4.60, 4.4.5).
// RUN: %clipc -T ps_5_0 -E ps --target=vulkan --validate %s -o - | FileCheck %s --check-prefix=VULKAN
// RUN: %clipc -T ps_5_0 -E ps --target=vulkan --pixel-bindings=64 --validate %s -o - | FileCheck %s --check-prefix=GIVEN
// RUN: %clipc -T ps_5_0 -E ps --target=vulkan -fvk-t-shift 8 all --validate %s -o - | FileCheck %s --check-prefix=SHIFTED
// RUN: %clipc -T ps_5_0 -E ps --target=glsl450 --validate %s -o - | FileCheck %s --check-prefix=OPENGL
// RUN: %clipc -T ps_5_0 -E ps --target=glsl450 --pixel-bindings=0 --validate %s -o - | FileCheck %s --check-prefix=NONE
// RUN: %clipc -T vs_5_0 -E vs --target=vulkan --pixel-bindings=64 --validate %s -o - 2>&1 | FileCheck %s --check-prefix=VERTEX
// RUN: %clipc -E vs --pixel-entry=ps --target=vulkan --pixel-bindings=64 %s -o %t.vert --pixel-output=%t.frag 2>&1 | FileCheck %s --check-prefix=PAIR
// RUN: FileCheck %s --check-prefix=TOGETHER --input-file=%t.frag
// VULKAN:      layout(std140, set = 0, binding = 256) uniform Tint {
// VULKAN:      layout(set = 0, binding = 288) uniform texture2D map;
// VULKAN-NEXT: layout(set = 3, binding = 2) uniform texture2D ramp;
// VULKAN-NEXT: layout(set = 0, binding = 272) uniform sampler near;
// GIVEN:       layout(std140, set = 0, binding = 64) uniform Tint {
// GIVEN:       layout(set = 0, binding = 96) uniform texture2D map;
// GIVEN-NEXT:  layout(set = 3, binding = 2) uniform texture2D ramp;
// GIVEN-NEXT:  layout(set = 0, binding = 80) uniform sampler near;
// SHIFTED:     layout(std140, set = 0, binding = 0) uniform Tint {
// SHIFTED:     layout(set = 0, binding = 8) uniform texture2D map;
// OPENGL:      layout(std140, binding = 0) uniform Tint {
// OPENGL:      layout(binding = 16) uniform sampler2D map;
// OPENGL-NEXT: layout(binding = 2) uniform sampler2D ramp;
// NONE:        layout(binding = 0) uniform sampler2D map;
// VERTEX:      warning: `--pixel-bindings` has no effect: this is a vertex shader [-Woption-without-effect]
// VERTEX:      layout(std140, set = 0, binding = 0) uniform Frame {
// PAIR:        warning: `--pixel-bindings` has no effect: the shaders of a pair are numbered together [-Woption-without-effect]
// TOGETHER:    layout(set = 0, binding = 32) uniform texture2D map;
cbuffer Frame : register(b0) { float4x4 view; };
cbuffer Tint : register(b0) { float4 tint; };
Texture2D map : register(t0);
[[vk::binding(2, 3)]] Texture2D ramp;
SamplerState near : register(s0);
float4 vs(float4 p : POSITION, out float2 uv : TEXCOORD) : SV_Position { uv = p.xy; return mul(p, view); }
float4 ps(float2 uv : TEXCOORD) : SV_Target { return map.Sample(near, uv) * ramp.Sample(near, uv) * tint; }
