// Where HLSL's offsets are std140's, members are written as they are.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl140 --validate %s -o %t
// AUTOUPDATE
struct Light {
  float3 color;
  float intensity;
  float4x4 shadow;
};
cbuffer Frame : register(b2) {
  float3 eye;
  float time;
  float2 size;
  bool fog;
  uint count;
  float4x4 world;
  row_major float4x3 skin[3];
  Light lights[2];
  int4 offsets[4];
};
cbuffer AllColumnMajor : register(b0) { float4x4 m; }

float4 main(float4 p : POSITION, uint i : INDEX) : SV_Position {
  float4 r = float4(eye, time) + size.xyxy + count;
  r += mul(p, world) + mul(p, m);
  r.xyz += mul(p, skin[i]);
  r.xyz += lights[i].color * lights[1].intensity;
  r += mul(lights[i].shadow, p) + offsets[i & 3];
  return fog ? r : -r;
}
