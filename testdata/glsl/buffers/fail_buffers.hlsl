// Arrays of buffers, and bindings, that a target cannot say.
// RUN: not %clipc -T vs_5_1 --target=glsl330 %s -o %t 2>&1 | FileCheck %s --check-prefix=GL330
// RUN: not %clipc -T vs_5_1 --target=glsl140 -DBUFFERS %s -o %t 2>&1 | FileCheck %s --check-prefix=GL140
// RUN: not %clipc -T vs_5_1 --target=glsl450 -DLISTS %s -o %t 2>&1 | FileCheck %s --check-prefix=GL450
// RUN: not %clipc -T vs_5_1 --target=vulkan -DCOLLIDE %s -o %t 2>&1 | FileCheck %s --check-prefix=VULKAN
// AUTOUPDATE
struct Camera { float4x4 view; float4 plane; };
// GL140: fail_buffers.hlsl:[[#@LINE+3]]:24: error: `cameras` is an array of constant buffers; target `glsl140` cannot describe the layout of its members [target-constant-buffer-array]
// GL140-NEXT:    [[#@LINE+2]] | ConstantBuffer<Camera> cameras[4] : register(b2);
// GL140-NEXT:       |                        ^~~~~~~
ConstantBuffer<Camera> cameras[4] : register(b2);
Texture2D maps[4] : register(t4);
// GL450: fail_buffers.hlsl:[[#@LINE+3]]:26: error: `lists` is an array of buffers; under target `glsl450` each buffer must be a variable of its own [target-array-of-buffers]
// GL450-NEXT:    [[#@LINE+2]] | StructuredBuffer<float4> lists[2] : register(t9);
// GL450-NEXT:       |                          ^~~~~
StructuredBuffer<float4> lists[2] : register(t9);
SamplerState linear_clamp : register(s0);
uint index;

#ifdef COLLIDE
// VULKAN: fail_buffers.hlsl:[[#@LINE+3]]:11: error: `Far` and `first` both become binding 32 of set 0; Vulkan numbers registers of all kinds together [target-bindings-collide]
// VULKAN-NEXT:    [[#@LINE+2]] | Texture2D first : register(t0);
// VULKAN-NEXT:       |           ^~~~~
Texture2D first : register(t0);
// VULKAN: note: `Far` is declared here
Texture2D second : register(t1);
cbuffer Far : register(b32) { float4 offset; };
#endif

float4 main(float4 p : POSITION) : SV_Position {
#if defined(COLLIDE)
  return first.SampleLevel(linear_clamp, p.xy, 0) + second.SampleLevel(linear_clamp, p.xy, 0) + offset;
#elif defined(LISTS)
  return lists[1][2];
#elif defined(BUFFERS)
  return mul(p, cameras[1].view);
#else
// GL330: fail_buffers.hlsl:[[#@LINE+6]]:17: error: the index of `cameras` is not constant; target `glsl330` accepts only constant indices of arrays of buffers, textures and samplers [target-buffer-index-not-constant]
// GL330-NEXT:    [[#@LINE+5]] |   return mul(p, cameras[index].view) + maps[index].SampleLevel(linear_clamp, p.xy, 0);
// GL330-NEXT:       |                 ^~~~~~~~~~~~~~
// GL330-NEXT: fail_buffers.hlsl:[[#@LINE+3]]:40: error: the index of `maps` is not constant; target `glsl330` accepts only constant indices of arrays of buffers, textures and samplers [target-buffer-index-not-constant]
// GL330-NEXT:    [[#@LINE+2]] |   return mul(p, cameras[index].view) + maps[index].SampleLevel(linear_clamp, p.xy, 0);
// GL330-NEXT:       |                                        ^~~~~~~~~~~
  return mul(p, cameras[index].view) + maps[index].SampleLevel(linear_clamp, p.xy, 0);
#endif
}
