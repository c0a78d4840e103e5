// An arm of ?:, or an element of a list, that takes several steps: they are done once each, before the value is used.
// RUN: %clipc -T vs_5_0 -E sines --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 -E splat
// RUN: %draw compare %s -T vs_5_0 -E cut
// RUN: %draw compare %s -T vs_5_0 -E out_argument
// RUN: %draw compare %s -T vs_5_0 -E sines
// RUN: %draw compare %s -T vs_5_0 -E nested
// RUN: %draw compare %s -T vs_5_0 -E list
// RUN: %draw compare %s -T vs_5_0 -E nested --target=essl300
cbuffer C {
  bool b;
  float2x2 m;
};

float4 splat(float4 p : POSITION) : SV_Position { return b ? (float4)(m * 2) : p; }

float4 cut(float4 p : POSITION) : SV_Position {
  float2x2 r = b ? float2x2(p.xyz * 2, 1) : m;
  return float4(r[0], r[1]);
}

float count(inout int i) {
  i += 1;
  return i;
}
float4 out_argument(float4 p : POSITION) : SV_Position {
  float x = 1;
  float y = b ? count(x) : 0;
  return p * y + x;
}

// CHECK: void main() {
// CHECK-NEXT: float s;
// CHECK-NEXT: float c_2;
// CHECK-NEXT: bool temporary = bool(c.b);
// CHECK-NEXT: vec4 temporary_2 = in_POSITION0;
// CHECK-NEXT: sincos(in_POSITION0.x, s, c_2);
// CHECK-NEXT: vec4 temporary_3 = vec4(s, c_2, 0.0, 1.0);
// CHECK-NEXT: gl_Position = temporary ? temporary_2 : temporary_3;
float4 sines(float4 p : POSITION) : SV_Position {
  float s, c;
  return b ? p : (sincos(p.x, s, c), float4(s, c, 0, 1));
}

static float last;
float keep(float x) {
  last = x;
  return x + last;
}
float4 nested(float4 p : POSITION) : SV_Position {
  float y = b ? keep(p.x) : (p.y > 0 ? keep(p.y) : keep(p.z));
  return p * y + last;
}

float4 list(float4 p : POSITION) : SV_Position {
  float s, c;
  float2 a[2] = {(sincos(p.x, s, c), float2(s, c)), (float2)(m * 2)[0]};
  return float4(a[0], a[1]);
}
