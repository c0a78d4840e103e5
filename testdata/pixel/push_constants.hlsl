// Push constants belong to a stage: those of the pixel shader may have the same name and other
// members, also where they become a block and a struct of uniforms.
// RUN: split-file %s %t
// RUN: %clipc -T vs_5_0 %t/vs.hlsl --validate -o - --pixel-shader=%t/ps.hlsl | FileCheck %s
// RUN: %clipc -T vs_5_0 %t/vs.hlsl --validate -o - --pixel-shader=%t/ps.hlsl --target=vulkan | FileCheck %s --check-prefix=VULKAN
// CHECK: float phase;
// VULKAN: push_constant) uniform
// VULKAN-NEXT: float phase;

//--- vs.hlsl
struct Pushed { float phase; };
[[vk::push_constant]] Pushed pushed;
float4 main(float4 p : POSITION, out float2 uv : TEXCOORD) : SV_Position {
  uv = p.xy;
  return p * pushed.phase;
}

//--- ps.hlsl
struct Pushed { [[vk::offset(4)]] uint index; };
[[vk::push_constant]] Pushed pushed;
float4 main(float2 uv : TEXCOORD) : SV_Target { return uv.xyxy * pushed.index; }
