// Structured and byte address buffers: blocks with an array of elements, whose parts are stored one by one; counters; what is coherent.
// RUN: %clipc -T ps_5_1 -spirv -S %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_1 -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_5_1 -spirv -fspv-target-env=vulkan1.0 -S %s -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T ps_5_1 -spirv -fspv-target-env=vulkan1.0 %s -o %t.spv && spirv-val --target-env vulkan1.0 %t.spv
// RUN: %clipc -T ps_5_1 -spirv -fspv-target-env=vulkan1.3 %s -o %t.spv && spirv-val --target-env vulkan1.3 %t.spv
// RUN: %draw compare %s -T ps_5_1 --target vulkan
struct Particle {
  float3 position;
  bool is_lit;
  float2x2 turn;
  int2 cells[2];
};
StructuredBuffer<Particle> read : register(t0);
RWStructuredBuffer<Particle> written : register(u1);
globallycoherent RWByteAddressBuffer bytes : register(u2);
ConsumeStructuredBuffer<float2> taken : register(u3);
RWStructuredBuffer<bool4> flags : register(u4);
RWStructuredBuffer<row_major float4x4> places : register(u5);

// CHECK-DAG: OpMemberName %Particle 1 "is_lit"
// CHECK-DAG: OpMemberDecorate %Particle 1 Offset 12
// CHECK-DAG: OpMemberDecorate %Particle 2 RowMajor
// CHECK-DAG: OpMemberDecorate %Particle 2 MatrixStride 8
// CHECK-DAG: OpMemberDecorate %Particle 3 Offset 32
// CHECK-DAG: OpDecorate %_runtimearr_Particle ArrayStride 48
// CHECK-DAG: OpMemberDecorate %places_block 0 ColMajor
// CHECK-DAG: OpMemberDecorate %places_block 0 MatrixStride 16
// CHECK-DAG: OpDecorate %read_block Block
// CHECK-DAG: OpMemberDecorate %read_block 0 NonWritable
// CHECK-DAG: OpMemberDecorate %bytes_block 0 Coherent
// CHECK-DAG: OpDecorate %written Binding
// CHECK:     OpVariable %_ptr_StorageBuffer_written_block StorageBuffer
// CHECK:     OpAccessChain %_ptr_StorageBuffer_float %written %int_0 {{%[0-9]+}} %int_0 %uint_1
// CHECK-NEXT: OpStore
// CHECK:     OpArrayLength %uint
// CHECK:     OpAtomicUMax %uint
// CHECK:     OpAtomicSMin %uint
// CHECK-NEXT: OpBitcast %int
// CHECK:     OpAtomicIAdd %int
// OLD: OpDecorate %read_block BufferBlock
// OLD: OpVariable %_ptr_Uniform_read_block Uniform
float4 main(float4 p : SV_Position, float4 value : VALUE) : SV_Target {
  const uint i = uint(p.x) % 16 + uint(p.y) % 16 * 16;
  written[i].position.yz = value.xy;
  written[i].turn[1] = value.zw;
  written[i].turn[0][i & 1] = value.x;
  places[i][i & 3].zw = value.xy;
  written[i].is_lit = value.x > value.y;
  written[i].cells[i & 1].y = (int)value.z;
  flags[i].yw = value.xy > value.zw;
  uint size, stride, old;
  read.GetDimensions(size, stride);
  bytes.InterlockedMax(4 * i, 7u, old);
  int least;
  bytes.InterlockedMin(4 * i, -(int)i, least);
  const Particle one = read[i];
  written[i + 256] = one;
  float4 sum = mul(float4(one.position, 1), places[i]) + float4(mul(value.xy, one.turn), one.cells[i & 1]);
  sum += float4(written[i + 256].position, 1) + places[i][2] + (flags[i] ? 1.0 : 2.0);
  sum.x += one.is_lit ? 1 : written[i].cells[1].y + old;
  InterlockedAdd(written[i].cells[0].x, 3);
  return sum + written[i].cells[0].x + size + stride + least + all(taken.Consume() == taken.Consume());
}
