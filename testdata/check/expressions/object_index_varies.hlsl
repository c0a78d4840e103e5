// From shader model 5.1 on an index that may differ between the pixels of a draw is marked by NonUniformResourceIndex, as DXC's
// documents have it; one of uniforms, of counters of loops and of what a wave agrees on need not be. Each array is named once.
// RUN: %clipc -T ps_6_0 %s --target=vulkan -o %t.frag 2>&1 | FileCheck %s
// RUN: %clipc -T ps_6_0 -E same %s --target=vulkan -Werror -o -
// RUN: %clipc -T vs_5_1 -E vertex %s --target=vulkan -o %t.vert 2>&1 | FileCheck %s --check-prefix=VERTEX
Texture2D a[4] : register(t0);
Texture2D b[4] : register(t4);
Texture2D c[4] : register(t8);
Texture2D d[4] : register(t12);
StructuredBuffer<uint> kinds : register(t16);
RWStructuredBuffer<uint> counts : register(u0);
struct Material { float4 tint; };
ConstantBuffer<Material> materials[4] : register(b1);
SamplerState s;
cbuffer Draw { uint kind, count; float4 splits; };
uint cascade(float z) {
  uint i = 0;
  if (z > splits.x) i = 1;
  return i;
}
uint through(uint i) { return i + 1; }
float4 main(float4 p : SV_Position, nointerpolation uint which : KIND) : SV_Target {
  // CHECK: [[#@LINE+1]]:16: warning: the index of `a` may differ between the pixels of a draw call, where the result is undefined; `NonUniformResourceIndex` says that this is meant [-Wobject-index-varies]
  float4 r = a[which].Load(0) + a[through(which)].Load(0);
  // CHECK-NOT: index of `a`
  // CHECK: [[#@LINE+1]]:10: warning: the index of `b` may differ
  r += b[cascade(p.z)].Load(0);
  uint last = 0;
  for (uint i = 0; i < 4; ++i) {
    last = i;
    if (p.x < splits[i]) break;
  }
  // CHECK: [[#@LINE+1]]:10: warning: the index of `c` may differ
  r += c[last].Load(0);
  uint old;
  InterlockedAdd(counts[0], 1, old);
  // CHECK: [[#@LINE+1]]:10: warning: the index of `d` may differ
  r += d[old & 3].Load(0);
  // CHECK: [[#@LINE+1]]:18: warning: the index of `materials` may differ
  r += materials[which].tint;
  return r + a[NonUniformResourceIndex(which)].Load(0);
  // CHECK-NOT: warning
}
float4 same(float4 p : SV_Position, nointerpolation uint which : KIND) : SV_Target {
  float4 r = a[kind].Load(0) + b[kinds[kind]].Load(0) + c[through(kind)].Load(0);
  for (uint i = 0; i < count; ++i) r += d[i].Load(0);
  for (uint j = 0; j < which; ++j) r += d[j].Load(0);
  if (which > 1) {
    uint k = 1;
    r += a[k].Load(0);
    if (kind) k = 2;
    r += b[k].Load(0);
  }
  uint agreed = WaveReadLaneFirst(which);
  r += c[agreed].Load(0) + materials[kind].tint;
  return r + d[NonUniformResourceIndex(which)].SampleLevel(s, p.xy, 0);
}
// VERTEX: warning: the index of `a` may differ between the vertices of a draw call
float4 vertex(uint i : SV_InstanceID) : SV_Position { return a[i].Load(0); }
