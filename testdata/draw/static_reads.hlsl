// The initial value of a static variable that reads a texture or a buffer is computed where main begins.
// RUN: %draw compare %s -T vs_5_0 --target all
// RUN: %clipc -T vs_5_0 --target=glsl330 --validate %s -E textures -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 -spirv %s -o %t.spv && spirv-val %t.spv
Texture2D image : register(t0);
SamplerState smooth : register(s0);
StructuredBuffer<float4> elements : register(t1);
Buffer<float4> texels : register(t2);

static float4 sampled = image.SampleLevel(smooth, float2(0.25, 0.5), 0);
static const float4 loaded = image[uint2(1, 2)] * 2;
static float4 list[2] = {elements[1] + texels[2], sampled};
static float4 after = sampled + loaded;

float4 main(float4 p : P) : SV_Position { return list[1] + list[0] * p + after; }

// CHECK:      void main() {
// CHECK-NEXT: sampled = textureLod(
// CHECK-NEXT: loaded = texelFetch(
// CHECK-NEXT: after = sampled + loaded;
float4 textures(float4 p : P) : SV_Position { return after + p; }
