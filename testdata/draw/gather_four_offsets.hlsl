// A Gather with an offset for each texel takes component i of the gather with offset i: dxc's lowering to DXIL (GenerateDxilGather of
// HLOperationLower.cpp). GLSL's textureGatherOffsets takes the upper left texel at each offset, so the steps to the four texels are added.
// Offsets that are not known, or beyond 31, which is what OpenGL promises, take four gathers.
// RUN: %clipc -T ps_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 --target=vulkan --validate %s -o %t
// RUN: %clipc -T ps_5_0 --target=essl310 --validate %s -o %t
// RUN: %clipc -T ps_5_0 -E numbers --validate %s -o - | FileCheck %s --check-prefix=NUMBERS
// RUN: %draw compare %s -T ps_5_0 --target glsl450,vulkan --ints 0..3
Texture2D map;
Texture2D<int2> cells;
SamplerState s;
int2 o;
float4 main(float2 uv : UV) : SV_Target {
  // CHECK: vec4 r = textureGatherOffsets(map, vs_UV0, ivec2[4](ivec2(0, 1), ivec2(2), ivec2(3, 0), ivec2(-8, 7)), 1);
  float4 r = map.GatherGreen(s, uv, int2(0, 0), int2(1, 1), int2(2, 0), int2(-8, 7));
  // CHECK: r += vec4(textureGatherOffset(map, vs_UV0, ivec2(1)).x, textureGatherOffset(map, vs_UV0, globals.o).y, textureGatherOffset(map, vs_UV0, ivec2(2)).z, textureGatherOffset(map, vs_UV0, ivec2(3)).w);
  r += map.GatherRed(s, uv, int2(1, 1), o, int2(2, 2), int2(3, 3));
  // CHECK: SV_Target0 = r + vec4(textureGatherOffset(map, vs_UV0, ivec2(31)).x,
  return r + map.GatherRed(s, uv, int2(31, 31), int2(0, 0), int2(0, 0), int2(0, 0));
}
// NUMBERS: = ivec4(textureGatherOffset(cells, vs_UV0, globals.o, 1).x, textureGatherOffset(cells, vs_UV0, globals.o, 1).y,
int4 numbers(float2 uv : UV) : SV_Target { return cells.GatherGreen(s, uv, o, o, o, o); }
