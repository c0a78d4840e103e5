// Up to shader model 5.0 an instruction names its texture, sampler or buffer by a number: fxc X3512, "sampler array index must be a
// literal expression"; DXC's docs/DXIL.rst, "The index must be constant for SM5.0 and below". Counters of loops with known bounds
// become literals, and so do parameters whose arguments are constants.
// RUN: not %clipc -T ps_5_0 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_3_0 -E old %s -o - 2>&1 | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T ps_5_1 -Werror %s --target=vulkan --validate -o - | FileCheck %s --check-prefix=NEWER
// RUN: %clipc -T ps_5_0 -E known %s --target=glsl450 --validate -o - | FileCheck %s --check-prefix=KNOWN
Texture2D maps[3];
Texture2D grid[2][2];
SamplerState s, taps[2];
StructuredBuffer<float4> rows[2];
uint kind;
static const uint kSecond = 1;
float4 read(uint i, float2 uv) { return maps[i].Sample(s, uv); }
float4 main(float2 uv : UV) : SV_Target {
  // CHECK: [[#@LINE+2]]:19: error: the index of `maps` is not constant; profiles before ps_5_1 choose a texture, sampler or buffer by constants, and by counters of loops that count from one to another [object-index-not-literal, X3512]
  // NEWER: texture(sampler2D(maps[globals.kind], s), vs_UV0)
  float4 r = maps[kind].Sample(s, uv);
  // CHECK: [[#@LINE+1]]:16: error: the index of `grid` is not constant
  r += grid[1][kind].Sample(s, uv);
  // CHECK: [[#@LINE+1]]:28: error: the index of `taps` is not constant
  r += maps[0].Sample(taps[kind], uv);
  // CHECK: [[#@LINE+1]]:13: error: the index of `rows` is not constant
  r += rows[kind][0];
  // CHECK-NOT: error
  for (uint i = 0; i < 3; ++i) r += maps[i].Sample(s, uv);
  return r + maps[kSecond].Sample(s, uv) + read(1, uv);
}
// KNOWN: for (uint i = 0u; i < 3u; ++i)
float4 known(float2 uv : UV) : SV_Target {
  float4 r = 0;
  for (uint i = 0; i < 3; ++i) r += maps[i].Sample(s, uv);
  return r + maps[kSecond].Sample(s, uv) + read(1, uv);
}
sampler2D old_maps[2];
float which;
// OLD: [[#@LINE+1]]:71: error: the index of `old_maps` is not constant
float4 old(float2 uv : TEXCOORD) : COLOR { return tex2D(old_maps[(int)which], uv); }
