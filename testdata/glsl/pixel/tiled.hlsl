// Tiled resources: the clamp and the status of a read, which Direct3D 11.2 has after its offset, as
// GL_ARB_sparse_texture_clamp and GL_ARB_sparse_texture2 have them. An offset of zero is left out.
// RUN: %clipc %s -T ps_5_0 -E ps --validate -o - 2>&1 | FileCheck %s
// RUN: %clipc %s -T ps_5_0 -E ps --target=vulkan --validate -o /dev/null
// RUN: %clipc %s -T ps_5_0 -E ps --target=glsl460 --validate -o /dev/null
// AUTOUPDATE
Texture1D line1;
Texture2D map;
Texture2DArray maps;
Texture2D<int2> numbers;
Texture3D volume;
TextureCube sky;
TextureCubeArray skies;
Texture2DMS<float4> samples;
RWTexture2D<float> image : register(u2);
SamplerState smooth;
SamplerComparisonState compare;

float4 ps(float2 uv : UV, nointerpolation int at : AT) : SV_Target {
  uint status;
  float4 sum = map.Sample(smooth, uv, int2(0, 0), 0.5);
  sum += map.Sample(smooth, uv, int2(1, 2), uv.x);
  sum += map.Sample(smooth, uv, int2(0, 0), 0.5, status);
  sum += CheckAccessFullyMapped(status) ? 1 : 0;
  sum += sky.Sample(smooth, uv.xyx, 0.5);
  sum += sky.Sample(smooth, uv.xyx, 0.5, status);
  sum += line1.SampleBias(smooth, uv.x, 1, 1, 0.5);
  sum += map.SampleBias(smooth, uv, 1, int2(1, 0), 0.5, status) * status;
  sum += map.SampleGrad(smooth, uv, uv, uv, int2(1, 0), 0.5, status) * status;
  sum += map.SampleLevel(smooth, uv, 0, int2(0, 0), status) * status;
  sum += map.SampleLevel(smooth, uv, 0, int2(3, 0), status) * status;
  sum += map.SampleCmp(compare, uv, 0.5, int2(0, 0), 0.5, status) * status;
  sum += map.SampleCmpLevelZero(compare, uv, 0.5, int2(1, 0), status) * status;
  sum += skies.SampleCmp(compare, uv.xyxy, 0.5, 2, status) * status;
  sum += map.Gather(smooth, uv, int2(0, 0), status) * status;
  sum += map.GatherGreen(smooth, uv, int2(1, 0), status) * status;
  sum += map.GatherCmp(compare, uv, 0.5, int2(1, 0), status) * status;
  sum += numbers.Load(int3(1, 2, 0), int2(0, 1), status).xyxy * status;
  sum += samples.Load(int2(1, 2), 1, int2(0, 0), status) * status;
  sum += image.Load(int2(1, 2), status) * status;
  sum += maps.Sample(smooth, uv.xyx, int2(0, 0), 1, status) * status;
  sum += map.GatherBlue(smooth, uv, int2(0, 0), int2(0, 1), int2(1, 0), at, status) * status;
  float half_status;
  sum += volume.SampleLevel(smooth, uv.xyx, 0, int3(0, 0, 0), half_status) * half_status;
  return sum;
}

// CHECK: #version 450
// CHECK-NEXT: #extension GL_ARB_sparse_texture2 : require
// CHECK-NEXT: #extension GL_ARB_sparse_texture_clamp : require
// CHECK-EMPTY:
// CHECK-NEXT: layout(binding = 2, r32f) uniform image2D image;  // u2
// CHECK-NEXT: layout(binding = 17) uniform sampler2D map_smooth;  // map : t1 with smooth : s0
// CHECK-NEXT: layout(binding = 16) uniform sampler2DShadow map_compare;  // map : t1 with compare : s1
// CHECK-NEXT: layout(binding = 21) uniform samplerCube sky;  // t5 with smooth : s0
// CHECK-NEXT: layout(binding = 18) uniform sampler1D line1;  // t0 with smooth : s0
// CHECK-NEXT: layout(binding = 22) uniform samplerCubeArrayShadow skies;  // t6 with compare : s1
// CHECK-NEXT: layout(binding = 19) uniform isampler2D numbers;  // t3
// CHECK-NEXT: layout(binding = 23) uniform sampler2DMS samples;  // t7
// CHECK-NEXT: layout(binding = 20) uniform sampler2DArray maps;  // t2 with smooth : s0
// CHECK-NEXT: layout(binding = 24) uniform sampler3D volume;  // t4 with smooth : s0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec2 vs_UV0;  // uv : UV0
// CHECK-NEXT: layout(location = 1) flat in int vs_AT0;  // at : AT0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) out vec4 SV_Target0;  // ps : SV_Target0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint status;
// CHECK-NEXT:     SV_Target0 = textureClampARB(map_smooth, vs_UV0, 0.5);
// CHECK-NEXT:     SV_Target0 += textureOffsetClampARB(map_smooth, vs_UV0, ivec2(1, 2), vs_UV0.x);
// CHECK-NEXT:     vec4 temporary;
// CHECK-NEXT:     status = uint(sparseTextureClampARB(map_smooth, vs_UV0, 0.5, temporary));
// CHECK-NEXT:     SV_Target0 += temporary;
// CHECK-NEXT:     SV_Target0 += float(sparseTexelsResidentARB(int(status)) ? 1 : 0);
// CHECK-NEXT:     SV_Target0 += textureClampARB(sky, vs_UV0.xyx, 0.5);
// CHECK-NEXT:     vec4 temporary_2;
// CHECK-NEXT:     status = uint(sparseTextureClampARB(sky, vs_UV0.xyx, 0.5, temporary_2));
// CHECK-NEXT:     SV_Target0 += temporary_2;
// CHECK-NEXT:     SV_Target0 += textureOffsetClampARB(line1, vs_UV0.x, 1, 0.5, 1.0);
// CHECK-NEXT:     vec4 temporary_3;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseTextureOffsetClampARB(map_smooth, vs_UV0, ivec2(1, 0), 0.5, temporary_3, 1.0)), temporary_3) * float(status);
// CHECK-NEXT:     vec4 temporary_4;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseTextureGradOffsetClampARB(map_smooth, vs_UV0, vs_UV0, vs_UV0, ivec2(1, 0), 0.5, temporary_4)), temporary_4) * float(status);
// CHECK-NEXT:     vec4 temporary_5;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseTextureLodARB(map_smooth, vs_UV0, 0.0, temporary_5)), temporary_5) * float(status);
// CHECK-NEXT:     vec4 temporary_6;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseTextureLodOffsetARB(map_smooth, vs_UV0, 0.0, ivec2(3, 0), temporary_6)), temporary_6) * float(status);
// CHECK-NEXT:     float temporary_7;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseTextureClampARB(map_compare, vec3(vs_UV0, 0.5), 0.5, temporary_7)), temporary_7) * float(status);
// CHECK-NEXT:     float temporary_8;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseTextureLodOffsetARB(map_compare, vec3(vs_UV0, 0.5), 0.0, ivec2(1, 0), temporary_8)), temporary_8) * float(status);
// CHECK-NEXT:     float temporary_9;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseTextureClampARB(skies, vs_UV0.xyxy, 0.5, 2.0, temporary_9)), temporary_9) * float(status);
// CHECK-NEXT:     vec4 temporary_10;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseTextureGatherARB(map_smooth, vs_UV0, temporary_10)), temporary_10) * float(status);
// CHECK-NEXT:     vec4 temporary_11;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseTextureGatherOffsetARB(map_smooth, vs_UV0, ivec2(1, 0), temporary_11, 1)), temporary_11) * float(status);
// CHECK-NEXT:     vec4 temporary_12;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseTextureGatherOffsetARB(map_compare, vs_UV0, 0.5, ivec2(1, 0), temporary_12)), temporary_12) * float(status);
// CHECK-NEXT:     ivec4 temporary_13;
// CHECK-NEXT:     SV_Target0 += vec4(uvec4((status = uint(sparseTexelFetchOffsetARB(numbers, ivec2(1, 2), 0, ivec2(0, 1), temporary_13)), temporary_13.xy).xyxy) * status);
// CHECK-NEXT:     vec4 temporary_14;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseTexelFetchARB(samples, ivec2(1, 2), 1, temporary_14)), temporary_14) * float(status);
// CHECK-NEXT:     vec4 temporary_15;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseImageLoadARB(image, ivec2(1, 2), temporary_15)), temporary_15.x) * float(status);
// CHECK-NEXT:     vec4 temporary_16;
// CHECK-NEXT:     SV_Target0 += (status = uint(sparseTextureClampARB(maps, vs_UV0.xyx, 1.0, temporary_16)), temporary_16) * float(status);
// CHECK-NEXT:     uint temporary_17;
// CHECK-NEXT:     uint temporary_18;
// CHECK-NEXT:     vec4 temporary_19;
// CHECK-NEXT:     vec4 temporary_20;
// CHECK-NEXT:     vec4 temporary_21;
// CHECK-NEXT:     vec4 temporary_22;
// CHECK-NEXT:     vec4 temporary_23;
// CHECK-NEXT:     vec4 temporary_24;
// CHECK-NEXT:     vec4 temporary_25;
// CHECK-NEXT:     vec4 temporary_26;
// CHECK-NEXT:     SV_Target0 += (temporary_17 = 0u, (temporary_20 = (temporary_17 = uint(sparseTextureGatherARB(map_smooth, vs_UV0, temporary_19, 2)), temporary_19), (temporary_22 = (temporary_18 = uint(sparseTextureGatherOffsetARB(map_smooth, vs_UV0, ivec2(0, 1), temporary_21, 2)), temporary_21), (temporary_17 = sparseTexelsResidentARB(int(temporary_17)) ? temporary_18 : temporary_17, (temporary_24 = (temporary_18 = uint(sparseTextureGatherOffsetARB(map_smooth, vs_UV0, ivec2(1, 0), temporary_23, 2)), temporary_23), (temporary_17 = sparseTexelsResidentARB(int(temporary_17)) ? temporary_18 : temporary_17, (temporary_26 = (temporary_18 = uint(sparseTextureGatherOffsetARB(map_smooth, vs_UV0, ivec2(vs_AT0), temporary_25, 2)), temporary_25), (temporary_17 = sparseTexelsResidentARB(int(temporary_17)) ? temporary_18 : temporary_17, (status = temporary_17, vec4(temporary_20.x, temporary_22.y, temporary_24.z, temporary_26.w)))))))))) * float(status);
// CHECK-NEXT:     float half_status;
// CHECK-NEXT:     vec4 temporary_27;
// CHECK-NEXT:     SV_Target0 += (half_status = float(uint(sparseTextureLodARB(volume, vs_UV0.xyx, 0.0, temporary_27))), temporary_27) * half_status;
// CHECK-NEXT: }
