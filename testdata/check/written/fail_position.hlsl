// The position is written on every path. Oracles: fxc X4580; dxc's validator, "Not all elements of SV_Position were written" (DXC's
// test incompletePos.hlsl); a path without it is fxc's X4000, a warning.
// RUN: split-file %s %t
// RUN: not %clipc -T vs_5_0 -fsyntax-only %t/never.hlsl 2>&1 | FileCheck %t/never.hlsl
// RUN: not %clipc -T vs_5_0 -fsyntax-only %t/part.hlsl 2>&1 | FileCheck %t/part.hlsl
// RUN: not %clipc -T vs_6_0 -fsyntax-only %t/out.hlsl 2>&1 | FileCheck %t/out.hlsl
// RUN: %clipc -T vs_5_0 -fsyntax-only %t/path.hlsl 2>&1 | FileCheck %t/path.hlsl
// RUN: %clipc -T vs_5_0 -fsyntax-only -Wno-position-not-always-written %t/path.hlsl 2>&1 | count 0
// RUN: %clipc -T vs_5_0 -fsyntax-only %t/every.hlsl 2>&1 | count 0
//--- never.hlsl
struct Out {
  float4 position : SV_Position;
  float4 color : COLOR;
};
cbuffer Planes {
  float4 plane;
};
[clipplanes(plane)]
Out main(float4 p : POSITION) {
  Out o;
  o.color = p;
  return o;
}
// CHECK: never.hlsl:2:21: error: the position `position` is never written; a vertex shader writes all four components [position-not-written, X4580]
//--- part.hlsl
float4 main(float4 p : POSITION) : SV_Position {
  float4 result;
  result.xyz = p.xyz;
  return result;
}
// CHECK: part.hlsl:1:36: error: the position `SV_Position` is not written completely; a vertex shader writes all four components [position-not-written, X4580]
//--- out.hlsl
void main(float4 p : POSITION, out float4 position : SV_Position) {}
// CHECK: error: the position `position` is never written
//--- path.hlsl
struct Out {
  float4 position : SV_Position;
};
Out main(float4 p : POSITION, int kind : KIND) {
  Out o;
  switch (kind) {
    case 0: o.position = p; break;
    case 1: o.position = -p; break;
  }
  return o;
}
// CHECK: path.hlsl:2:21: warning: the position `position` is not written on every path; where it is not, the vertex is anywhere [-Wposition-not-always-written]
//--- every.hlsl
struct Out {
  float4 position : SV_Position;
};
static const int kind = 1;
void Move(float4 p, out Out o) { o.position = p; }
Out Make(float4 p, int n) {
  Out o;
  if (n > 3) {
    o.position.xy = p.yx;
    o.position.zw = 1;
  } else if (n > 2) {
    Move(p, o);
  } else {
    switch (kind) {
      case 1: o.position = p; break;
    }
    for (int i = 0; i < n; ++i) {
      if (p.x > i) break;
    }
  }
  return o;
}
Out main(float4 p : POSITION, int n : N) {
  if (n > 4) return Make(p, n);
  Out o = { p };
  const Out other = o;
  while (true) {
    if (n++ > 3) return other;
  }
}
