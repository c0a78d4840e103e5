// What a group exchanges over a barrier of the device's memory is coherent: GLSL 4.60, "Memory qualifiers".
// RUN: %clipc -T cs_5_0 --verify --dump-after=mark-coherent --stop-after=mark-coherent %s | FileCheck %s
// RUN: %clipc -T cs_5_0 %s -o - --validate | FileCheck %s --check-prefix=GLSL
// RUN: %clipc -T cs_5_0 -DGROUP %s -o - | FileCheck %s --check-prefix=GROUP
// RUN: %draw compare %s -T cs_5_0
// AUTOUPDATE
#ifdef GROUP
#define AllMemoryBarrierWithGroupSync GroupMemoryBarrierWithGroupSync
#endif
RWStructuredBuffer<uint> b, o, counts;
RWTexture2D<uint> t;
[numthreads(64, 1, 1)] void main(uint i : SV_GroupIndex) {
  b[i] = i;
  t[uint2(i, 0)] = i;
  InterlockedAdd(counts[i & 1], 1);
  AllMemoryBarrierWithGroupSync();
  o[i] = b[63 - i] + t[uint2(63 - i, 0)];
}

// CHECK: program cs_5_0 form resolved
// CHECK-NEXT: resource RWStructuredBuffer<uint> b : u0
// CHECK-NEXT: resource RWStructuredBuffer<uint> o : u0
// CHECK-NEXT: resource RWStructuredBuffer<uint> counts : u0
// CHECK-NEXT: resource RWTexture2D<uint> t : u0
// CHECK-NEXT: group 64 1 1
// CHECK-NEXT: input uint in_SV_GROUPINDEX0 : SV_GroupIndex0 builtin group_index
// CHECK-NEXT: entry void main(uint i) {
// CHECK-NEXT:   store(b, i, value: i)
// CHECK-NEXT:   store(t, convert<int2>(uint2(i, 0u)), value: i)
// CHECK-NEXT:   atomic_add(counts, i & 1u, value: 1u)
// CHECK-NEXT:   AllMemoryBarrierWithGroupSync()
// CHECK-NEXT:   store(o, i, value: structured_load(b, 63u - i) + image_load(t, convert<int2>(uint2(63u - i, 0u))))
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   main(in_SV_GROUPINDEX0)
// CHECK-NEXT: }

// GLSL: #version 450
// GLSL-EMPTY:
// GLSL-NEXT: layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;
// GLSL-EMPTY:
// GLSL-NEXT: layout(std430, binding = 0) coherent buffer b_block {  // u0
// GLSL-NEXT:     uint b[];
// GLSL-NEXT: };
// GLSL-NEXT: layout(std430, binding = 1) buffer o_block {  // u1
// GLSL-NEXT:     uint o[];
// GLSL-NEXT: };
// GLSL-NEXT: layout(std430, binding = 2) buffer counts_block {  // u2
// GLSL-NEXT:     uint counts[];
// GLSL-NEXT: };
// GLSL-NEXT: layout(binding = 3, r32ui) coherent uniform uimage2D t;  // u3
// GLSL-EMPTY:
// GLSL-NEXT: void main() {
// GLSL-NEXT:     uint i = gl_LocalInvocationIndex;
// GLSL-NEXT:     b[i] = i;
// GLSL-NEXT:     imageStore(t, ivec2(uvec2(i, 0u)), uvec4(i, 0u, 0u, 0u));
// GLSL-NEXT:     atomicAdd(counts[i & 1u], 1u);
// GLSL-NEXT:     memoryBarrier();
// GLSL-NEXT:     barrier();
// GLSL-NEXT:     o[i] = b[63u - i] + imageLoad(t, ivec2(uvec2(63u - i, 0u))).x;
// GLSL-NEXT: }

// GROUP: #version 450
// GROUP-EMPTY:
// GROUP-NEXT: layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;
// GROUP-EMPTY:
// GROUP-NEXT: layout(std430, binding = 0) buffer b_block {  // u0
// GROUP-NEXT:     uint b[];
// GROUP-NEXT: };
// GROUP-NEXT: layout(std430, binding = 1) buffer o_block {  // u1
// GROUP-NEXT:     uint o[];
// GROUP-NEXT: };
// GROUP-NEXT: layout(std430, binding = 2) buffer counts_block {  // u2
// GROUP-NEXT:     uint counts[];
// GROUP-NEXT: };
// GROUP-NEXT: layout(binding = 3, r32ui) uniform uimage2D t;  // u3
// GROUP-EMPTY:
// GROUP-NEXT: void main() {
// GROUP-NEXT:     uint i = gl_LocalInvocationIndex;
// GROUP-NEXT:     b[i] = i;
// GROUP-NEXT:     imageStore(t, ivec2(uvec2(i, 0u)), uvec4(i, 0u, 0u, 0u));
// GROUP-NEXT:     atomicAdd(counts[i & 1u], 1u);
// GROUP-NEXT:     memoryBarrierShared();
// GROUP-NEXT:     barrier();
// GROUP-NEXT:     o[i] = b[63u - i] + imageLoad(t, ivec2(uvec2(63u - i, 0u))).x;
// GROUP-NEXT: }
