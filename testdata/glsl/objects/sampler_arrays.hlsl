// An element of an array of samplers is a sampler of its own, with the texture or the array of textures that is read with it. The
// reflection says which register each is.
// RUN: %clipc -T ps_5_0 %s --target=glsl330 -o %t.frag --reflect=%t.json && FileCheck %s < %t.frag
// RUN: FileCheck %s --check-prefix=JSON < %t.json
// RUN: %clipc -T ps_5_0 %s --target=vulkan -o - | FileCheck %s --check-prefix=VULKAN
// RUN: %draw compare %s -T ps_5_0 --target=glsl330,essl300,essl100,vulkan
// CHECK-DAG: uniform sampler2D maps[2];  // t0 with samplers_0 : s2
// CHECK-DAG: uniform sampler2D map_samplers_0;  // map : t4 with samplers_0 : s2
// CHECK-DAG: uniform sampler2D map_samplers_2;  // map : t4 with samplers_2 : s4
// CHECK: texture(maps[1], vs_UV0)
// JSON:      "name": "samplers_2",
// JSON-NEXT: "type": "SamplerState",
// JSON-NEXT: "register": "s4",
// VULKAN: uniform sampler samplers[3];
Texture2D maps[2] : register(t0);
Texture2D map : register(t4);
SamplerState samplers[3] : register(s2);
float4 read(SamplerState all[3], float2 uv) { return map.Sample(all[2], uv); }
float4 main(float2 uv : UV) : SV_Target {
  return read(samplers, uv.yy) + maps[1].Sample(samplers[0], uv) + map.Sample(samplers[2], uv) + map.Sample(samplers[0], uv.yx);
}
// The counter of a loop with constant bounds becomes a constant, where an index needs one: fxc unrolls the loop.
// RUN: %clipc -T ps_5_0 -E counted %s --target=glsl330 --validate -o - | FileCheck %s --check-prefix=COUNTED
// RUN: %draw compare %s -T ps_5_0 -E counted --target=glsl330,essl300,vulkan
// COUNTED: texture(map_samplers_0, vs_UV0)
// COUNTED: texture(map_samplers_1, vs_UV0)
float4 tap(int n, float2 uv) { return map.Sample(samplers[n], uv); }
float4 counted(float2 uv : UV) : SV_Target {
  float4 sum = 0;
  [unroll] for (int i = 0; i < 2; ++i) sum += map.Sample(samplers[i], uv);
  for (int j = 2; j > 0; j--) sum += map.Sample(samplers[j], uv.yx) * j;
  return sum + tap(1, uv) - tap(2, uv);
}
