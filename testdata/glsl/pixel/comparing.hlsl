// The methods of textures that compare. The component of a GatherCmp makes no difference: vkd3d's gather-cmp.shader_test, line 42,
// checked against fxc and dxc.
// RUN: %clipc -T ps_6_8 --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_8 --target=essl320 -DES --validate --verify %s -o - | FileCheck %s --check-prefix=ES
Texture2D map;
Texture2DArray layers;
TextureCube sky;
TextureCubeArray skies;
SamplerComparisonState compares;
float4 main(float4 p : P) : SV_Target {
  float4 c = map.GatherCmp(compares, p.xy, p.z);
  c += map.GatherCmpRed(compares, p.xy, p.z, int2(1, -1));
  c += map.GatherCmp(compares, p.xy, p.z, int2(0, 1), int2(1, 1), int2(2, 1), int2(3, 1));
  c += skies.GatherCmp(compares, p, 0.5);
  c += map.GatherCmpGreen(compares, p.xz, p.w);
  c += map.GatherCmpBlue(compares, p.yz, p.w, int2(2, 2));
  c += map.GatherCmpAlpha(compares, p.zw, p.y);
  c += map.SampleCmpLevel(compares, p.xy, p.z, 2);
  c += map.SampleCmpLevel(compares, p.xy, p.z, 2, int2(1, 1));
  c += map.SampleCmpBias(compares, p.xy, p.z, 0.25, int2(1, 2));
  c += sky.SampleCmpBias(compares, p.xyz, p.w, 0.25);
  c += layers.SampleCmpGrad(compares, p.xyz, p.w, p.xy, p.zw, int2(1, 2));
  return c;
}
// CHECK: textureGather(map, vs_P0.xy, vs_P0.z)
// CHECK: textureGatherOffset(map, vs_P0.xy, vs_P0.z, ivec2(1, -1))
// CHECK: textureGatherOffsets(map, vs_P0.xy, vs_P0.z, ivec2[4](ivec2(0, 2), ivec2(2), ivec2(3, 1), ivec2(3, 1)))
// CHECK: textureGather(skies, vs_P0, 0.5)
// CHECK: textureGather(map, vs_P0.xz, vs_P0.w)
// CHECK: textureGatherOffset(map, vs_P0.yz, vs_P0.w, ivec2(2))
// CHECK: textureGather(map, vs_P0.zw, vs_P0.y)
// CHECK: textureLod(map, vec3(vs_P0.xy, vs_P0.z), 2.0)
// CHECK: textureLodOffset(map, vec3(vs_P0.xy, vs_P0.z), 2.0, ivec2(1))
// CHECK: textureOffset(map, vec3(vs_P0.xy, vs_P0.z), ivec2(1, 2), 0.25)
// CHECK: texture(sky, vec4(vs_P0.xyz, vs_P0.w), 0.25)
// CHECK: textureGradOffset(layers, vec4(vs_P0.xyz, vs_P0.w), vs_P0.xy, vs_P0.zw, ivec2(1, 2))
// ES: textureGather(map, vs_P0.xy, vs_P0.z)
