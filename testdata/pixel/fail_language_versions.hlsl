// A pixel shader is read by the rules of the vertex shader's version of the language: from HLSL
// 2018 on, a Store takes a struct.
// RUN: not %clipc -T vs_6_0 -HV 2016 -E vs --pixel-shader=%s --pixel-entry=ps %s -o - 2>&1 | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T vs_6_0 -E vs --pixel-shader=%s --pixel-entry=ps --validate %s -o - | FileCheck %s
struct Pair {
  float a, b;
};
RWByteAddressBuffer written;
struct Varyings {
  float4 position : SV_Position;
  float4 read : READ;
  float4 unread : UNREAD;
};
Varyings vs(float4 v : POSITION) {
  Varyings o = {v, v, v};
  return o;
}
// CHECK: out vec4 i_read;
// CHECK-NOT: unread
float4 ps(Varyings i) : SV_Target {
  // OLD: error: the pixel shader cannot be read: {{.*}}language_versions.hlsl:[[#@LINE+2]]:20: argument 2 of `Store` has type `Pair`; it must be `uint` [pixel-shader]
  const Pair pair = {i.read.x, i.read.y};
  written.Store(0, pair);
  return 0;
}
