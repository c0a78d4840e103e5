// RUN: not %clipc -T vs_5_0 %s -o %t 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_4_1 %s -o %t 2>&1 | FileCheck %s --check-prefix=OLD
Texture2D map;
SamplerState s;
float4 main(float2 uv : TEXCOORD) : SV_Position {
  // CHECK: error: offset 32 is given to `Gather`; it must be from -32 to 31 [texture-offset-range, X4566]
  // OLD: error: offset 32 is given to `Gather`; it must be from -8 to 7
  float4 r = map.Gather(s, uv, int2(32, 0));
  // CHECK: error: offset 8 is given to `SampleLevel`; it must be from -8 to 7
  return r + map.SampleLevel(s, uv, 0, int2(8, 0));
}
