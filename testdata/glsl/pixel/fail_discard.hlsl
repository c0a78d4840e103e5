// A discard before a derivative waits for the end of the shader, which stores must not, and is a statement.
// RUN: not %clipc -T ps_5_0 -E with_stores %s -o - 2>&1 | FileCheck %s --check-prefix=STORES
// RUN: not %clipc -T ps_5_0 -E in_expression %s -o - 2>&1 | FileCheck %s --check-prefix=EXPRESSION
Texture2D map;
SamplerState linearly;
RWTexture2D<float4> log : register(u1);

float4 with_stores(float2 uv : UV) : SV_Target {
  clip(uv);
  log[int2(0, 0)] = map.Sample(linearly, uv);
  return 0;
}
// STORES: error: `discard` comes before a derivative or a sample, and the shader writes to buffers or textures; clipc does not translate the two together for target `glsl450` [target-discard]

float4 in_expression(float2 uv : UV) : SV_Target {
  for (int i = 0; i < 4; ++i, clip(uv)) uv += 1;
  return uv.x;
}
// EXPRESSION: error: `clip` is part of an expression; it must be a statement of its own [clip-in-expression]
