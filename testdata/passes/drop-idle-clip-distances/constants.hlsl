// Distances at the end that are non-negative constants, written as such or computed, clip nothing: they are removed, with a
// warning. The others keep their indices, and the image is the same.
// RUN: %clipc -T vs_5_0 -E scalars --dump-after=split-variables %s 2>&1 | FileCheck %s --check-prefix=IDLE
// RUN: %clipc -T vs_5_0 -E scalars --dump-after=drop-idle-clip-distances %s 2>&1 | FileCheck %s --check-prefix=DROPPED
// RUN: %clipc -T vs_5_0 -E all --dump-after=drop-idle-clip-distances %s 2>&1 | FileCheck %s --check-prefix=NO-OUTPUT
// RUN: %clipc -T vs_5_0 -E vector --validate --reflect=%t.json %s -o - 2>&1 | FileCheck %s --check-prefix=VECTOR
// RUN: FileCheck %s --check-prefix=MASK --input-file %t.json
// RUN: %clipc -T vs_5_0 -E all --validate --reflect=%t.all.json %s -o - 2>&1 | FileCheck %s --check-prefix=ALL
// RUN: FileCheck %s --check-prefix=NONE --input-file %t.all.json
// RUN: %clipc -T vs_5_0 -E scalars %s -o - 2>&1 | FileCheck %s --check-prefix=SCALARS
// RUN: %clipc -T vs_5_0 -E branches %s -o - 2>&1 | FileCheck %s --check-prefix=BRANCHES
// RUN: %clipc -T vs_5_0 -E zero %s -o - 2>&1 | FileCheck %s --check-prefix=ZERO
// RUN: %clipc -T vs_5_0 -E elements %s -o - 2>&1 | FileCheck %s --check-prefix=ELEMENTS
// RUN: %clipc -T vs_5_0 -E with_cull %s -o - 2>&1 | FileCheck %s --check-prefix=CULL
// RUN: %clipc -T vs_5_0 -E before %s -o - 2>&1 | FileCheck %s --check-prefix=BEFORE --implicit-check-not=warning
// RUN: %clipc -T vs_5_0 -E negative %s -o - 2>&1 | FileCheck %s --check-prefix=NEGATIVE --implicit-check-not=warning
// RUN: %clipc -T vs_5_0 -E infinite %s -o - 2>&1 | FileCheck %s --check-prefix=INFINITE --implicit-check-not=warning
// RUN: %clipc -T vs_5_0 -E changed %s -o - 2>&1 | FileCheck %s --check-prefix=CHANGED --implicit-check-not=warning
// RUN: %clipc -T vs_5_0 -E given %s -o - 2>&1 | FileCheck %s --check-prefix=GIVEN --implicit-check-not=warning
// RUN: %clipc -T vs_5_0 -E early %s -o - 2>&1 | FileCheck %s --check-prefix=EARLY --implicit-check-not=warning
// RUN: %draw compare -T vs_5_0 -E vector %s
// RUN: %draw compare -T vs_5_0 -E all %s
// RUN: %draw compare -T vs_5_0 -E scalars %s
// RUN: %draw compare -T vs_5_0 -E branches %s
// RUN: %draw compare -T vs_5_0 -E zero %s
// RUN: %draw compare -T vs_5_0 -E elements %s
// RUN: %draw compare -T vs_5_0 -E with_cull --target glsl450 %s
float4 plane;
bool is_on;
static const float kNever = 1;

struct Vector {
  float4 position : SV_Position;
  float4 distances : SV_ClipDistance;
};

// VECTOR: constants.hlsl:[[#@LINE-3]]:{{.*}}warning: clip distances from 1 on are constants that never clip; they are left out, so a pixel shader cannot read them [-Wclip-distances-left-out]
// VECTOR: // clip distances written: 0x1
// VECTOR-NEXT: out float gl_ClipDistance[1];
// VECTOR: gl_ClipDistance[0] = distances.x;
// VECTOR-NEXT: }
// MASK: "clipDistanceMask": 1,
Vector vector(float4 p : POSITION) {
  Vector o;
  o.position = p;
  o.distances = float4(dot(p, plane), kNever, 0, 1e30);
  return o;
}

// ALL: warning: clip distances from 0 on are constants
// ALL: #version
// ALL-NOT: Distance
// ALL: void main() {
// ALL-NEXT: gl_Position = in_POSITION0;
// ALL-NEXT: }
// NONE: "clipDistanceMask": 0,
Vector all(float4 p : POSITION) {
  Vector o;
  o.position = p;
  o.distances = 1;
  return o;
}

struct Scalars {
  float4 position : SV_Position;
  float first : SV_ClipDistance0;
  float second : SV_ClipDistance1;
  float third : SV_ClipDistance2;
};

// IDLE: output float clip_distance[3] : SV_ClipDistance0
// IDLE: main void main() {
// IDLE: clip_distance[0u] = first
// IDLE-NEXT: clip_distance[1u] = second
// IDLE-NEXT: clip_distance[2u] = third
// DROPPED: output float clip_distance[1] : SV_ClipDistance0
// DROPPED: main void main() {
// DROPPED: float second = never
// DROPPED-NEXT: float third = 3.0
// DROPPED-NEXT: clip_distance[0u] = first
// DROPPED-NEXT: }
// NO-OUTPUT-NOT: clip_distance
// NO-OUTPUT: main void main() {
// NO-OUTPUT-NOT: clip_distance

// What only a removed distance was computed from is removed later.
// SCALARS: warning: clip distances from 1 on
// SCALARS: gl_Position = in_POSITION0;
// SCALARS-NEXT: float first = dot(in_POSITION0, globals.plane);
// SCALARS-NEXT: gl_ClipDistance[0] = first;
// SCALARS-NEXT: }
Scalars scalars(float4 p : POSITION) {
  Scalars o;
  float never = kNever;
  o.position = p;
  o.first = dot(p, plane);
  o.second = never;
  o.third = 3;
  return o;
}

// BRANCHES: warning: clip distances from 1 on
// BRANCHES: out float gl_ClipDistance[1];
Scalars branches(float4 p : POSITION) {
  Scalars o;
  o.position = p;
  o.first = dot(p, plane);
  o.second = 1;
  if (is_on) o.second = 2;
  o.third = o.second;
  return o;
}

// ZERO: warning: clip distances from 1 on
// ZERO: out float gl_ClipDistance[1];
Scalars zero(float4 p : POSITION) {
  Scalars o = (Scalars)0;
  o.position = p;
  o.first = dot(p, plane);
  return o;
}

struct Elements {
  float4 position : SV_Position;
  float2 distances[2] : SV_ClipDistance;
};
// ELEMENTS: warning: clip distances from 1 on
// ELEMENTS: out float gl_ClipDistance[1];
Elements elements(float4 p : POSITION) {
  Elements o;
  o.position = p;
  o.distances[0].x = dot(p, plane);
  o.distances[0].y = 1;
  o.distances[1] = float2(1, 2);
  return o;
}

struct WithCull {
  float4 position : SV_Position;
  float2 distances : SV_ClipDistance;
  float cull : SV_CullDistance;
  float4 color : COLOR;
};
// CULL: warning: clip distances from 0 on
// CULL-NOT: gl_ClipDistance
// CULL: out float gl_CullDistance[1];
WithCull with_cull(float4 p : POSITION) {
  WithCull o;
  o.position = p;
  o.distances = float2(1, 2);
  o.cull = p.x;
  o.color = p.wzyx;
  return o;
}

// The indices of others stay, so a constant before them does too.
// BEFORE: out float gl_ClipDistance[3];
Scalars before(float4 p : POSITION) {
  Scalars o;
  o.position = p;
  o.first = 1;
  o.second = 2;
  o.third = p.x;
  return o;
}

// NEGATIVE: out float gl_ClipDistance[3];
Scalars negative(float4 p : POSITION) {
  Scalars o;
  o.position = p;
  o.first = 1;
  o.second = 1;
  o.third = -1;
  return o;
}

// INFINITE: out float gl_ClipDistance[3];
Scalars infinite(float4 p : POSITION) {
  Scalars o;
  o.position = p;
  o.first = o.second = 1;
  o.third = asfloat(0x7f800000);
  return o;
}

// CHANGED: out float gl_ClipDistance[3];
Scalars changed(float4 p : POSITION) {
  Scalars o;
  o.position = p;
  o.first = o.second = o.third = 1;
  o.third -= p.x;
  return o;
}

void set(out float distance, float4 p) { distance = p.x; }
// GIVEN: out float gl_ClipDistance[3];
Scalars given(float4 p : POSITION) {
  Scalars o;
  o.position = p;
  o.first = o.second = o.third = 1;
  set(o.third, p);
  return o;
}

// EARLY: out float gl_ClipDistance[4];
Vector early(float4 p : POSITION) {
  Vector o;
  o.position = p;
  o.distances = 1;
  if (is_on) return o;
  o.distances.x = p.x;
  return o;
}
