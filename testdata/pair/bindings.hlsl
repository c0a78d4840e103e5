// Where an option says how registers are bound, the registers of both halves are bound so; SDL has sets of its own for a pixel shader.
// RUN: %clipc %s -E vs --pixel-entry=ps --target=vulkan --bindings=sdl -o %t.vert --pixel-output=%t.frag --validate
// RUN: cat %t.vert %t.frag | FileCheck %s --check-prefix=SDL
// SDL:      layout(std140, set = 1, binding = 0) uniform Frame {
// SDL:      #version 460
// SDL:      layout(std140, set = 3, binding = 0) uniform Tint {
// SDL:      layout(set = 2, binding = 0) uniform texture2D map;
// SDL-NEXT: layout(set = 2, binding = 0) uniform sampler map_sampler;
// RUN: %clipc %s -E vs --pixel-entry=ps --target=vulkan --bindings=nvrhi -o %t.vert --pixel-output=%t.frag --validate
// RUN: cat %t.vert %t.frag | FileCheck %s --check-prefix=NVRHI
// NVRHI: binding = 256) uniform Frame {
// NVRHI: binding = 256) uniform Tint {
cbuffer Frame : register(b0) { float4x4 view; };
cbuffer Tint : register(b0) { float4 tint; };
Texture2D map : register(t0);
SamplerState map_sampler : register(s0);
float4 vs(float4 p : POSITION, out float2 uv : TEXCOORD) : SV_Position { uv = p.xy; return mul(p, view); }
float4 ps(float2 uv : TEXCOORD) : SV_Target { return map.Sample(map_sampler, uv) * tint; }
