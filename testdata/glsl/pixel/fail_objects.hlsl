// What is not an element for an atomic operation, not a texel, and not one object.
// RUN: not %clipc -T ps_5_0 -E index %s -o - 2>&1 | FileCheck %s --check-prefix=INDEX
// RUN: not %clipc -T ps_5_0 -E tight --target=glsl450 %s -o - 2>&1 | FileCheck %s --check-prefix=TIGHT
// RUN: not %clipc -T ps_5_0 -E texels -DTEXELS %s -o - 2>&1 | FileCheck %s --check-prefix=TEXELS
// RUN: not %clipc -T ps_6_0 -E wide -DWIDE --target=vulkan %s -o - 2>&1 | FileCheck %s --check-prefix=WIDE
// RUN: not %clipc -T ps_6_0 -E chosen --target=vulkan %s -o - 2>&1 | FileCheck %s --check-prefix=CHOSEN
// RUN: not %clipc -T ps_6_0 -E chosen_texture %s -o - 2>&1 | FileCheck %s --check-prefix=TEXTURE
struct Element {
  uint counts[3];
  float3 tight;
};
RWStructuredBuffer<Element> elements : register(u1);
uint index(int i : I) : SV_Target {
  InterlockedAdd(elements[0].tight[i], 1);
  return 0;
}
// INDEX: [[#@LINE-3]]:18: error: `InterlockedAdd` changes an element of an unordered access view, `buffer[i]`, a member of one of a structured buffer, or a `groupshared` variable, that is an `int` or `uint` [intrinsic-atomic-target, X3013]

struct Signed {
  int counts[3];
  float3 tight;
};
RWStructuredBuffer<Signed> integers : register(u2);
// What lies tighter than std430 is words, which are unsigned.
uint tight() : SV_Target {
  InterlockedMax(integers[0].counts[1], 1);
  return 0;
}
// TIGHT: error: a `Signed` is written into a structured buffer; target `glsl450` lays it out differently from Direct3D [target-structured-store]

#ifdef TEXELS
Texture2D<Element> map;
float4 texels() : SV_Target { return map.Load(0).tight.x; }
// TEXELS: [[#@LINE-2]]:1: error: `Texture2D` has elements of type `Element`; clipc translates textures and typed buffers of scalars and vectors of 32 bits [texel-type]
#endif

#ifdef WIDE
// DXC has elements of at most four 32-bit quantities; no format of GLSL or Vulkan holds a double.
Buffer<double2> doubles;
RWBuffer<uint64_t> longs : register(u1);
Texture2D<int64_t> signed_longs;
RasterizerOrderedBuffer<uint64_t4> ordered : register(u2);
float4 wide() : SV_Target { return (float)(doubles.Load(0).x + signed_longs.Load(0)); }
// WIDE: [[#@LINE-5]]:1: error: `Buffer` has elements of type `double2`; clipc translates textures and typed buffers of scalars and vectors of 32 bits [texel-type]
// WIDE: [[#@LINE-5]]:1: error: `RWBuffer` has elements of type `uint64_t`;
// WIDE: [[#@LINE-5]]:1: error: `Texture2D` has elements of type `int64_t`;
// WIDE: [[#@LINE-5]]:1: error: `RasterizerOrderedBuffer` has elements of type `uint64_t4`;
#endif

SamplerState first, second;
Texture2D one, other;
float4 chosen(float2 uv : UV) : SV_Target { return one.Sample(uv.x > 0 ? first : second, uv); }
// CHOSEN: error: `?:` of type `SamplerState` is not one particular global; an object cannot be chosen at run time [object-not-global, X3031]
float4 chosen_texture(float2 uv : UV) : SV_Target { return (uv.x > 0 ? one : other).Sample(first, uv); }
// TEXTURE: error: `?:` of type `Texture2D<float4>` is not one particular global; an object cannot be chosen at run time [object-not-global, X3031]
