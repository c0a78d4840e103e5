// Arrays without a size are Vulkan's only, an error where one is read, and so is an index that differs from vertex to vertex.
// RUN: not %clipc -T vs_5_1 --target=glsl450 %s -o - 2>&1 | FileCheck %s
// RUN: %clipc -T vs_5_1 --target=vulkan --validate %s -o %t.vert
// AUTOUPDATE
// CHECK: fail_arrays_without_size.hlsl:[[#@LINE+3]]:11: error: `maps` is an array without a size; target `glsl450` has no such arrays, `vulkan` has [target-array-without-size]
// CHECK-NEXT:     [[#@LINE+2]] | Texture2D maps[] : register(t0, space1);
// CHECK-NEXT:       |           ^~~~
Texture2D maps[] : register(t0, space1);
Texture2D few[4];
struct Material { float4 color; };
// CHECK-NEXT: fail_arrays_without_size.hlsl:[[#@LINE+3]]:26: error: `materials` is an array without a size; target `glsl450` has no such arrays, `vulkan` has [target-array-without-size]
// CHECK-NEXT:    [[#@LINE+2]] | ConstantBuffer<Material> materials[] : register(b0, space2);
// CHECK-NEXT:       |                          ^~~~~~~~~
ConstantBuffer<Material> materials[] : register(b0, space2);
SamplerState state;

float4 main(float4 p : POSITION, uint i : INDEX) : SV_Position {
  uint n = NonUniformResourceIndex(i);
// CHECK-NEXT: fail_arrays_without_size.hlsl:[[#@LINE+3]]:15: warning: `NonUniformResourceIndex` has no effect under target `glsl450`, whose index of textures and buffers must be the same for all vertices of a draw call; `vulkan` has no such rule [-Wtarget-non-uniform]
// CHECK-NEXT:    [[#@LINE+2]] |   return maps[n].SampleLevel(state, p.xy, 0) + few[n & 3].SampleLevel(state, p.xy, 0) * materials[2].color;
// CHECK-NEXT:       |               ^
  return maps[n].SampleLevel(state, p.xy, 0) + few[n & 3].SampleLevel(state, p.xy, 0) * materials[2].color;
}
