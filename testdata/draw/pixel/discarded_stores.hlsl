// A store whose value an expression uses does not happen in a pixel whose discard waits for a derivative.
// RUN: %draw compare %s -T ps_5_0 -E stores --target glsl450 --target vulkan
// RUN: %draw compare %s -T ps_5_0 -E loops --target glsl450 --target vulkan
// RUN: %draw compare %s -T ps_5_0 -E arguments --target glsl450 --target vulkan
// RUN: %clipc -T ps_5_0 -E stores -spirv %s -o %t.spv && spirv-val %t.spv
// RUN: %clipc -T ps_5_0 -E loops --validate %s -o - | FileCheck %s
RWBuffer<uint> counts : register(u1);
RWTexture2D<float> image : register(u2);
RWStructuredBuffer<uint> elements : register(u3);

float4 stores(float4 p : SV_Position, float2 uv : TEXCOORD0) : SV_Target {
  if (uv.x < 0)
    discard;
  uint2 texel = uint2(p.xy);
  float sum = (image[texel] = uv.y) + 1;
  if (elements[texel.x & 3] > 3)
    sum += counts[texel.x & 7] = 2;
  return sum + ddx(uv.x);
}

// CHECK: while ((temporary = float(n), (is_discarded ? false : (imageStore({{.*}}), true), temporary)) < 3.0 && n < 8)
float4 loops(float4 p : SV_Position, float2 uv : TEXCOORD0) : SV_Target {
  if (uv.x < 0)
    discard;
  uint2 texel = uint2(p.xy);
  int n = 0;
  while ((image[texel] = n) < 3 && n < 8)
    ++n;
  do
    n += 2;
  while ((elements[texel.x] = n) < 6);
  return n + ddx(uv.x);
}

float Doubled(inout float value) { return value *= 2; }

float4 arguments(float4 p : SV_Position, float2 uv : TEXCOORD0) : SV_Target {
  clip(uv.y);
  uint2 texel = uint2(p.xy);
  float values[2] = {image[texel] = 3, Doubled(image[texel])};
  return values[0] + values[1] + ddx(uv.x);
}
