// A local array of textures, samplers or structs of them is chosen from by the counter of a loop with constant bounds: fxc unrolls the
// loop, and an index is a literal then. With the hint [unroll] and without it.
// RUN: %clipc -T ps_5_0 %s --target=glsl450 --validate -o - | FileCheck %s
// RUN: %clipc -T ps_6_0 %s --target=vulkan --validate -o %t.frag
// RUN: %draw compare %s -T ps_5_0 --target=glsl450,glsl330,essl300,vulkan
// RUN: %draw compare %s -T ps_5_0 -E more --target=glsl450,vulkan
Texture2D a : register(t0);
Texture2D b : register(t1);
Texture2D c : register(t2);
SamplerState near : register(s0);
SamplerState far : register(s1);
// CHECK: SV_Target0 = {{.*}}
float4 main(float2 u : U) : SV_Target {
  Texture2D t[2] = { a, b };
  float4 sum = 0;
  for (int i = 0; i < 2; i++) sum += t[i].SampleLevel(near, u, 0);
  [unroll] for (int j = 1; j >= 0; --j) {
    sum += t[j].SampleLevel(near, u * 0.5, 0) * (j + 1);
  }
  return sum;
}

struct Layer { Texture2D map; float scale; };
float4 pick(int n, float2 u) {
  Texture2D t[3] = { a, b, c };
  return t[n].SampleLevel(near, u, 0);
}
float4 more(float2 u : U) : SV_Target {
  SamplerState s[2] = { near, far };
  Texture2D grid[2][2] = { { a, b }, { b, c } };
  Layer layers[2];
  layers[0].map = a;
  layers[0].scale = 0.5;
  layers[1].map = c;
  layers[1].scale = 2;
  float4 sum = 0;
  for (uint i = 0; i < 2; ++i) {
    sum += a.SampleLevel(s[i], u, 0) + layers[i].map.SampleLevel(near, u, 0) * layers[i].scale;
    for (int k = 0; k <= 1; k += 1) sum += grid[i][k].SampleLevel(s[1 - k], u, 0);
  }
  return sum + pick(0, u) + pick(2, u);
}
