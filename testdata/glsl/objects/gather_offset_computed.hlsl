// From 5.0 on the one offset of a Gather need not be known: Direct3D 11's gather4_po.
// RUN: %clipc -T vs_5_0 --target=glsl450 --verify --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=essl310 --validate %s -o - | FileCheck %s --check-prefix=ES
// RUN: %clipc -T vs_5_0 --target=essl320 --validate %s -o - | FileCheck %s --check-prefix=CORE
// RUN: %draw compare %s -T vs_5_0 --target glsl400,glsl450,essl310,essl320,vulkan --ints 0..3
// ES: #extension GL_EXT_gpu_shader5 : require
// CORE-NOT: #extension
Texture2D map;
Texture2D<int2> whole;
SamplerState s;
int2 away;  // one of --ints
float4 Tap(float2 uv, int2 o) { return map.Gather(s, uv, o); }
float4 main(float2 uv : TEXCOORD) : SV_Position {
  // CHECK: textureGatherOffset(map, in_TEXCOORD0, globals.away)
  float4 r = map.Gather(s, uv, away);
  // CHECK: textureGatherOffset(map, in_TEXCOORD0, globals.away.yx - 1, 2)
  r += map.GatherBlue(s, uv, away.yx - 1);
  // CHECK: Tap(in_TEXCOORD0, ivec2(globals.away.x, 1))
  r += Tap(uv, int2(away.x, 1)) + Tap(uv, int2(2, 1));
  // CHECK: ivec2(i, -i)
  for (int i = 0; i < away.x; ++i) r += map.Gather(s, uv, int2(i, -i));
  return r + whole.GatherGreen(s, uv, away);
}
