// fxc compiles ContactHardeningShadows11.hlsl of the DirectX SDK without a warning of `v0`: what one iteration writes, the next reads. An offset
// of a Gather that counts makes clipc unroll such loops.
// RUN: %clipc -T ps_4_1 -Werror %s -o /dev/null
// RUN: %clipc -T ps_5_0 -Werror %s -o /dev/null
Texture2D t;
SamplerState s;
float4 main(float2 tc : T) : SV_Target {
  float4 r = 0;
  int row, col;
  float2 v0[5];
  [unroll(9)] for (row = -4; row <= 4; row += 2) {
    [unroll] for (col = -4; col <= 4; col += 2) {
      float4 v1 = t.Sample(s, tc, int2(col, row));
      if (col == -4) {
        if (row > -4) r += v0[0].x;
      }
      if (row != 4) v0[(col + 4) / 2] = v1.xy;
    }
  }
  return r;
}
