// Rasterizer-ordered objects: the whole of main is one section of
// GL_ARB_fragment_shader_interlock, as in DXC's `-spirv`. Other invocations see what is stored in
// them, and in an object that is globallycoherent.
// RUN: %clipc %s -T ps_5_1 --validate -o - 2>&1 | FileCheck %s --check-prefixes=CHECK,PIXEL
// RUN: %clipc %s -T ps_5_1 -E by_sample --validate -o - 2>&1 | FileCheck %s --check-prefix=SAMPLE
// RUN: %clipc %s -T ps_5_1 -E unordered --validate -o - 2>&1 | FileCheck %s --check-prefix=UNORDERED
// RUN: %clipc %s -T ps_6_0 --target=vulkan --validate -o - 2>&1 | FileCheck %s --check-prefixes=CHECK,PIXEL
// RUN: %clipc %s -T ps_6_0 -spirv -o %t.spv
// CHECK: #extension GL_ARB_fragment_shader_interlock : require
// PIXEL: layout(pixel_interlock_ordered) in;
// CHECK: rgba32f) coherent uniform image2D layers;
// CHECK: r32ui) coherent uniform uimageBuffer counts;
// CHECK: coherent buffer items_block
// CHECK: coherent buffer bytes_block
// SAMPLE: layout(sample_interlock_ordered) in;
// UNORDERED-NOT: interlock
// UNORDERED: ) coherent uniform image2D shared_image;
// UNORDERED: coherent buffer shared_list_block
// UNORDERED-NOT: Interlock
struct Item { float4 color; uint next; };
RasterizerOrderedTexture2D<float4> layers : register(u1);
RasterizerOrderedBuffer<uint> counts : register(u2);
RasterizerOrderedStructuredBuffer<Item> items : register(u3);
RasterizerOrderedByteAddressBuffer bytes : register(u4);
RasterizerOrderedTexture3D<float4> unused : register(u5);
globallycoherent RWTexture2D<float4> shared_image : register(u6);
globallycoherent RWStructuredBuffer<float4> shared_list : register(u7);

// CHECK: void main() {
// CHECK-NEXT: beginInvocationInterlockARB();
// CHECK: imageStore(layers,
// CHECK: endInvocationInterlockARB();
// CHECK-NEXT: }
float4 main(float4 p : SV_Position, float4 color : COLOR) : SV_Target {
  const uint2 place = uint2(p.xy);
  const float4 below = layers[place];
  if (below.a > 1) discard;
  layers[place] = lerp(below, color, color.a);
  counts[place.x] += 1;
  items[place.x].color = color;
  items[items.IncrementCounter()].next = bytes.Load(place.y * 4);
  bytes.Store(place.y * 4, place.x);
  return layers[place];
}

float4 by_sample(float4 p : SV_Position, uint at : SV_SampleIndex) : SV_Target {
  return layers[uint2(p.xy)] += at;
}

float4 unordered(float4 p : SV_Position) : SV_Target {
  shared_list[uint(p.x)] = p;
  return shared_image[uint2(p.xy)] = p;
}
