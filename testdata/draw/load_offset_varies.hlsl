// An offset of a Load that is not constant is added to the location. Oracles: "Programmable Offsets" of shader model 6.7; before it fxc
// X4566 and dxc refuse it, and glslang adds it.
// RUN: %clipc -T ps_6_7 --validate %s -o - 2>&1 | FileCheck %s --implicit-check-not=warning:
// RUN: %clipc -T ps_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=OLD
// RUN: %draw compare %s -T ps_6_7
Texture2D map;
Texture2DArray layers;
int2 o;
float4 main(nointerpolation uint2 at : AT) : SV_Target {
  // CHECK: vec4 r = texelFetch(map, ivec2(vs_AT0 & 3u) + imod(globals.o, ivec2(4)), 0);
  // OLD: [[#@LINE+1]]:40: warning: the offset given to `Load` is not constant; clipc adds it to the location, fxc and dxc before ps_6_7 report an error [-Wtexture-offset-varies]
  float4 r = map.Load(int3(at & 3, 0), o % 4);
  // CHECK: texelFetch(layers, ivec3(ivec2(vs_AT0 & 3u), 1) + ivec3(imod(globals.o, ivec2(4)), 0), 0);
  return r + layers.Load(int4(at & 3, 1, 0), o % 4);
}
