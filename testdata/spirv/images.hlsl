// Textures and typed buffers that are written: images with a format, whose texels have four components.
// RUN: %clipc -T ps_5_1 -spirv -S %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_1 -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_5_1 -spirv -fspv-target-env=vulkan1.0 %s -o %t.spv && spirv-val --target-env vulkan1.0 %t.spv
// RUN: %clipc -T ps_5_1 -spirv -fspv-target-env=vulkan1.3 %s -o %t.spv && spirv-val --target-env vulkan1.3 %t.spv
// RUN: %clipc -T ps_5_1 -E formats -spirv -S %s -o - | FileCheck %s --check-prefix=FORMATS
// RUN: %draw compare %s -T ps_5_1 --target vulkan
RWTexture2D<float4> picture : register(u0);
[[vk::image_format("rgba8")]] RWTexture2D<float4> colors : register(u1);
globallycoherent RWTexture1D<float2> pairs : register(u2);
RWBuffer<uint> counts : register(u3);
RWTexture2DArray<int> signs[2] : register(u4);

// CHECK-DAG: OpCapability Image1D
// CHECK-DAG: OpCapability ImageBuffer
// CHECK-DAG: OpCapability ImageQuery
// CHECK-DAG: OpCapability StorageImageExtendedFormats
// CHECK:     OpDecorate %pairs Coherent
// CHECK-DAG: OpTypeImage %float 2D 0 0 0 2 Rgba32f
// CHECK-DAG: OpTypeImage %float 1D 0 0 0 2 Rg32f
// CHECK-DAG: OpTypeImage %uint Buffer 0 0 0 2 R32ui
// CHECK-DAG: OpTypeImage %int 2D 0 1 0 2 R32i
// CHECK:     OpImageRead %v4float
// CHECK:     OpImageWrite
// CHECK:     [[TEXEL:%[0-9]+]] = OpImageTexelPointer %_ptr_Image_uint %counts {{%[0-9]+}} %uint_0
// CHECK-NEXT: OpAtomicIAdd %uint [[TEXEL]] %uint_1 %uint_0
// CHECK:     OpAtomicCompareExchange %int
// CHECK:     OpImageQuerySize %v3int
float4 main(float4 p : SV_Position, float4 value : VALUE) : SV_Target {
  const uint2 at = uint2(p.xy) % 16;
  const uint i = at.x + 16 * at.y;
  uint old, width, height, elements;
  int before;
  picture[at] = value + picture[at];
  pairs[i] = value.xy;
  InterlockedAdd(counts[i], 5, old);
  InterlockedCompareExchange(signs[1][uint3(at, 1)], 0, 9, before);
  signs[0].GetDimensions(width, height, elements);
  return picture[at] + pairs[i].xyxy + old + before + signs[1][uint3(at, 1)] + width + height + elements;
}

// FORMATS-NOT: StorageImageExtendedFormats
// FORMATS: OpTypeImage %float 2D 0 0 0 2 Rgba8
float4 formats(float4 p : SV_Position) : SV_Target {
  colors[uint2(p.xy)].y = 1;
  return p;
}
