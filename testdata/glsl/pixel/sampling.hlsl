// Every way to sample with a level of detail from the neighbours, and without.
// RUN: %clipc -T ps_5_0 --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 --target=vulkan --validate --verify %s -o - | FileCheck %s --check-prefix=VULKAN
// RUN: %clipc -T ps_5_0 --target=essl320 -DES --validate --verify %s -o - | FileCheck %s --check-prefix=ES
Texture2D map;
Texture2DArray layers;
TextureCube sky;
SamplerState linearly;
SamplerComparisonState compares;
struct Maps {
  Texture2D map;
  SamplerState state;
};
float4 Read(Maps maps, float2 uv) { return maps.map.Sample(maps.state, uv); }

float4 main(float3 p : P, float flag : FLAG) : SV_Target {
  float4 c = map.Sample(linearly, p.xy, int2(1, -1));
  c += map.SampleBias(linearly, p.xy, 0.5);
  c += map.SampleBias(linearly, p.xy, 0.5, int2(2, 2));
  c += map.SampleGrad(linearly, p.xy, p.xy, p.yz);
  c += map.SampleCmp(compares, p.xy, p.z);
  c += map.SampleCmp(compares, p.xy, p.z, int2(3, 3));
  c += layers.SampleCmpLevelZero(compares, p, 0.25);
  c += sky.SampleCmpLevelZero(compares, p, 0.25);
  c += flag > 0 ? map.Sample(linearly, p.zz) : 0;
  Maps maps = {map, linearly};
  c += Read(maps, p.zx);
  c += ddx(p.x) + ddy_coarse(p.y) + fwidth(p.z);
#ifndef ES
  c += map.CalculateLevelOfDetail(linearly, p.xy);
  c += sky.CalculateLevelOfDetailUnclamped(linearly, p);
#endif
  return c;
}
// CHECK: textureOffset(map_linearly, vs_P0.xy, ivec2(1, -1))
// CHECK: texture(map_linearly, vs_P0.xy, 0.5)
// CHECK: textureOffset(map_linearly, vs_P0.xy, ivec2(2), 0.5)
// CHECK: textureGrad(map_linearly, vs_P0.xy, vs_P0.xy, vs_P0.yz)
// CHECK: texture(map_compares, vec3(vs_P0.xy, vs_P0.z))
// CHECK: textureOffset(map_compares, vec3(vs_P0.xy, vs_P0.z), ivec2(3))
// CHECK: textureGrad(layers, vec4(vs_P0, 0.25), vec2(0.0), vec2(0.0))
// CHECK: textureGrad(sky_compares, vec4(vs_P0, 0.25), vec3(0.0), vec3(0.0))
// Both sides of `?:` are evaluated, as in HLSL before 2021: the neighbours take the sample too.
// CHECK: = texture(map_linearly, vs_P0.zz)
// CHECK: dFdx(vs_P0.x) + -dFdyCoarse(vs_P0.y) + fwidth(vs_P0.z)
// CHECK: textureQueryLod(map_linearly, vs_P0.xy).x
// CHECK: textureQueryLod(sky_linearly, vs_P0).y
// VULKAN: textureOffset(sampler2D(map, linearly), vs_P0.xy, ivec2(1, -1))
// VULKAN: dFdyCoarse(vs_P0.y)
// ES: dFdx(vs_P0.x) + -dFdy(vs_P0.y) + fwidth(vs_P0.z)
