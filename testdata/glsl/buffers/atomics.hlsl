// Atomic operations on unordered access views, which a vertex shader has from Direct3D 11.1 on.
// RUN: %clipc -T vs_5_0 --target=glsl450 --verify --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=vulkan --verify --validate %s -o %t.vert
// RUN: %clipc -T vs_5_0 --target=essl310 -DNO_IMAGES --verify --validate %s -o %t.vert
// AUTOUPDATE
RWStructuredBuffer<uint> counts : register(u0);
RWStructuredBuffer<int> signed_counts : register(u1);
RWByteAddressBuffer bytes : register(u2);
#ifndef NO_IMAGES
RWBuffer<uint> typed : register(u3);
RWTexture2D<int> picture : register(u4);
#endif
float4 main(float4 p : POSITION, uint id : SV_VertexID) : SV_Position {
  uint before, byte_before;
  int least;
  float converted;
  InterlockedAdd(counts[0], 1);
  InterlockedAdd(counts[id & 3], 2, before);
  InterlockedMin(signed_counts[1], -5, least);
  InterlockedMax(signed_counts[2], (int)id);
  InterlockedAnd(counts[1], 0xff);
  InterlockedOr(counts[2], id);
  InterlockedXor(counts[3], id, converted);
  bytes.InterlockedAdd(id * 4 + 4, 3, byte_before);
  bytes.InterlockedMax(16, 3);
  uint swapped, was;
  InterlockedExchange(counts[4], id, swapped);
  InterlockedCompareExchange(counts[5], 7, id, was);
  InterlockedCompareStore(counts[6], 7, id);
#ifndef NO_IMAGES
  InterlockedAdd(typed[id], 1, was);
  InterlockedMax(picture[uint2(1, id)], -2);
#endif
  counts[7] = id;
  return p + before + least + converted + byte_before + swapped + was;
}

// CHECK: #version 450
// CHECK-NEXT: #extension GL_ARB_shader_draw_parameters : require
// CHECK-EMPTY:
// CHECK-NEXT: layout(std430, binding = 0) buffer counts_block {  // u0
// CHECK-NEXT:     uint counts[];
// CHECK-NEXT: };
// CHECK-NEXT: layout(std430, binding = 1) buffer signed_counts_block {  // u1
// CHECK-NEXT:     int signed_counts[];
// CHECK-NEXT: };
// CHECK-NEXT: layout(std430, binding = 2) buffer bytes_block {  // u2
// CHECK-NEXT:     uint bytes[];
// CHECK-NEXT: };
// CHECK-NEXT: layout(binding = 3, r32ui) uniform uimageBuffer typed;  // u3
// CHECK-NEXT: layout(binding = 4, r32i) uniform iimage2D picture;  // u4
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: int bytes_max(uint address, int value) {
// CHECK-NEXT:     uint i = address / 4u;
// CHECK-NEXT:     uint word = bytes[i];
// CHECK-NEXT:     uint expected;
// CHECK-NEXT:     do {
// CHECK-NEXT:         expected = word;
// CHECK-NEXT:         word = atomicCompSwap(bytes[i], expected, uint(max(int(expected), value)));
// CHECK-NEXT:     } while (word != expected);
// CHECK-NEXT:     return int(word);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint id = uint(gl_VertexID - gl_BaseVertexARB);
// CHECK-NEXT:     uint before;
// CHECK-NEXT:     uint byte_before;
// CHECK-NEXT:     int least;
// CHECK-NEXT:     float converted;
// CHECK-NEXT:     atomicAdd(counts[0], 1u);
// CHECK-NEXT:     before = atomicAdd(counts[id & 3u], 2u);
// CHECK-NEXT:     least = atomicMin(signed_counts[1], -5);
// CHECK-NEXT:     atomicMax(signed_counts[2], int(id));
// CHECK-NEXT:     atomicAnd(counts[1], 255u);
// CHECK-NEXT:     atomicOr(counts[2], id);
// CHECK-NEXT:     converted = float(atomicXor(counts[3], id));
// CHECK-NEXT:     byte_before = atomicAdd(bytes[(id * 4u + 4u) / 4u], 3u);
// CHECK-NEXT:     bytes_max(16u, 3);
// CHECK-NEXT:     uint swapped;
// CHECK-NEXT:     uint was;
// CHECK-NEXT:     swapped = atomicExchange(counts[4], id);
// CHECK-NEXT:     was = atomicCompSwap(counts[5], 7u, id);
// CHECK-NEXT:     atomicCompSwap(counts[6], 7u, id);
// CHECK-NEXT:     was = imageAtomicAdd(typed, int(id), 1u);
// CHECK-NEXT:     imageAtomicMax(picture, ivec2(uvec2(1u, id)), -2);
// CHECK-NEXT:     counts[7] = id;
// CHECK-NEXT:     gl_Position = in_POSITION0 + float(before) + float(least) + converted + float(byte_before) + float(swapped) + float(was);
// CHECK-NEXT: }
