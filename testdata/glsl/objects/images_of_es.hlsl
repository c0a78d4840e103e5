// Images of OpenGL ES: GLSL ES 3.10 has them, with a word for those that a shader only reads or only writes unless they have one component
// of 32 bits (4.9, "Memory qualifiers"); 3.20 has atomic operations on them and images of buffers without an extension.
// RUN: %clipc %s -T ps_5_0 -E ps --target=essl320 --validate -o - | FileCheck %s --check-prefixes=CHECK,NEW
// RUN: %clipc %s -T ps_5_0 -E ps --target=essl310 --validate -o - | FileCheck %s --check-prefixes=OLD,CHECK
// RUN: %clipc %s -T vs_5_0 -E vs --target=essl310 --validate -o - | FileCheck %s --check-prefix=VERTEX
RWTexture2D<float4> written : register(u1);
RWTexture2DArray<int4> read : register(u2);
RWTexture2D<uint> counts : register(u3);
RWTexture3D<float> both : register(u4);
[[vk::image_format("rgba8")]] RWTexture2D<float4> small : register(u5);
RWBuffer<int> list : register(u6);
globallycoherent RWTexture2D<uint4> asked : register(u7);

// NEW-NOT: #extension
// OLD: #extension GL_EXT_texture_buffer : require
// OLD-NEXT: #extension GL_OES_shader_image_atomic : require
// CHECK: layout(binding = 1, rgba32f) writeonly uniform highp image2D written;  // u1
// CHECK-NEXT: layout(binding = 2, rgba32i) readonly uniform highp iimage2DArray read;  // u2
// CHECK-NEXT: layout(binding = 3, r32ui) uniform highp uimage2D counts;  // u3
// CHECK-NEXT: layout(binding = 4, r32f) uniform highp image3D both;  // u4
// CHECK-NEXT: layout(binding = 5, rgba8) writeonly uniform highp image2D small;  // u5
// CHECK-NEXT: layout(binding = 6, r32i) uniform highp iimageBuffer list;  // u6
// CHECK-NEXT: layout(binding = 7, rgba32ui) coherent readonly uniform highp uimage2D asked;  // u7
float4 ps(float4 p : POSITION0) : SV_Target {
  const int2 at = int2(p.xy);
  uint old, width, height;
  written[at] = p;
  small[at] = p;
  both[int3(at, 1)] += p.x;
  list[at.x] = list[at.y];
  // CHECK: imageAtomicAdd(counts,
  InterlockedAdd(counts[at], 1, old);
  InterlockedExchange(counts[at], 1, old);
  asked.GetDimensions(width, height);
  return read[int3(at, 0)] + old + width;
}

// VERTEX: layout(binding = 1, rgba32f) writeonly uniform highp image2D written;  // u1
float4 vs(float4 p : POSITION, uint i : SV_VertexID) : SV_Position {
  written[int2(i, 0)] = p;
  return p;
}
