// dxc's other layouts of buffers are accepted where the buffer lies in Direct3D as it does in them.
// RUN: not %clipc -T vs_6_0 -E other -fvk-use-gl-layout %s -o - 2>&1 | FileCheck %s --check-prefix=GL
// RUN: not %clipc -T vs_6_0 -E other -fvk-use-scalar-layout %s -o - 2>&1 | FileCheck %s --check-prefix=SCALAR
// RUN: not %clipc -T vs_6_0 -E tight -fvk-use-gl-layout --target=vulkan %s -o - 2>&1 | FileCheck %s --check-prefix=TIGHT
// RUN: %clipc -T vs_6_0 -E alike -fvk-use-gl-layout --target=vulkan %s -o %t.gl && %clipc -T vs_6_0 -E alike --target=vulkan %s -o %t.d3d && cmp %t.gl %t.d3d
// RUN: %clipc -T vs_6_0 -E alike -fvk-use-scalar-layout --target=vulkan %s -o %t.scalar && cmp %t.scalar %t.d3d
// RUN: %clipc -T vs_6_0 -E tight -fvk-use-scalar-layout --target=vulkan %s -o %t.tight
struct Item { float3 place; float size; };
cbuffer Alike : register(b0) { float4x4 view; float4 plane; Item items[2]; float3 eye; float time; };
// GL: [[#@LINE+2]]:9: error: `-fvk-use-gl-layout` with `Straddles`, which lies otherwise in Direct3D, is not supported [unsupported]
// GL-NOT: error
cbuffer Straddles : register(b1) { float first; float3 second; };
// SCALAR: [[#@LINE+2]]:9: error: `-fvk-use-scalar-layout` with `Padded`, which lies otherwise in Direct3D, is not supported [unsupported]
// SCALAR-NOT: error
cbuffer Padded : register(b2) { float4 numbers; float3 after; float2 last; };
StructuredBuffer<Item> list : register(t0);
// TIGHT: [[#@LINE+1]]:26: error: `-fvk-use-gl-layout` with `triples`, which lies otherwise in Direct3D, is not supported [unsupported]
StructuredBuffer<float3> triples : register(t1);

float4 alike(float4 p : POSITION) : SV_Position {
  return mul(p, view) + plane + items[1].size + float4(eye, time) + list[1].size;
}
float4 other(float4 p : POSITION) : SV_Position { return p + first + float4(second + after, last.x) + numbers; }
float4 tight(float4 p : POSITION) : SV_Position { return p + triples[1].xyzz; }
