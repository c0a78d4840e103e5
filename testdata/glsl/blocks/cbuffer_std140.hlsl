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

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: struct Light {
// CHECK-NEXT:     vec3 color;
// CHECK-NEXT:     float intensity;
// CHECK-NEXT:     mat4 shadow;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 2) uniform Frame {  // b2
// CHECK-NEXT:     vec3 eye;
// CHECK-NEXT:     float time;
// CHECK-NEXT:     vec2 size;
// CHECK-NEXT:     uint fog;
// CHECK-NEXT:     uint count;
// CHECK-NEXT:     layout(row_major) mat4 world;
// CHECK-NEXT:     mat4x3 skin[3];
// CHECK-NEXT:     layout(row_major) Light lights[2];
// CHECK-NEXT:     ivec4 offsets[4];
// CHECK-NEXT: } frame;
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform AllColumnMajor {  // b0
// CHECK-NEXT:     layout(row_major) mat4 m;
// CHECK-NEXT: } allColumnMajor;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-NEXT: layout(location = 1) in uint in_INDEX0;  // i : INDEX0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec4 r = vec4(frame.eye, frame.time) + frame.size.xyxy + float(frame.count);
// CHECK-NEXT:     r += frame.world * in_POSITION0 + allColumnMajor.m * in_POSITION0;
// CHECK-NEXT:     r.xyz += frame.skin[in_INDEX0] * in_POSITION0;
// CHECK-NEXT:     r.xyz += frame.lights[in_INDEX0].color * frame.lights[1].intensity;
// CHECK-NEXT:     r += in_POSITION0 * frame.lights[in_INDEX0].shadow + vec4(frame.offsets[in_INDEX0 & 3u]);
// CHECK-NEXT:     gl_Position = bool(frame.fog) ? r : -r;
// CHECK-NEXT: }
