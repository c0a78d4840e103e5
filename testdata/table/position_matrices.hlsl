// The reflection says how many matrices the position is multiplied by, one after the other.
//
// RUN: %clipc %s -T vs_5_0 -E one -o %t.vert --reflect=%t.one && FileCheck %s --check-prefix=ONE --input-file=%t.one
// RUN: %clipc %s -T vs_5_0 -E steps -o %t.vert --reflect=%t.steps && FileCheck %s --check-prefix=TWO --input-file=%t.steps
// RUN: %clipc %s -T vs_5_0 -E product -o %t.vert --reflect=%t.product && FileCheck %s --check-prefix=TWO --input-file=%t.product
// RUN: %clipc %s -T vs_5_0 -E rows -o %t.vert --reflect=%t.rows && FileCheck %s --check-prefix=TWO --input-file=%t.rows
// RUN: %clipc %s -T vs_5_0 -E branches -o %t.vert --reflect=%t.branches && FileCheck %s --check-prefix=TWO --input-file=%t.branches
// RUN: %clipc %s -T vs_5_0 -E called -o %t.vert --reflect=%t.called && FileCheck %s --check-prefix=THREE --input-file=%t.called
// RUN: %clipc %s -T vs_5_0 -E skinned -o %t.vert --reflect=%t.skinned && FileCheck %s --check-prefix=TWO --input-file=%t.skinned
// RUN: %clipc %s -T vs_5_0 -E fields -o %t.vert --reflect=%t.fields && FileCheck %s --check-prefix=ONE --input-file=%t.fields
// RUN: %clipc %s -T vs_5_0 -E early -o %t.vert --reflect=%t.early && FileCheck %s --check-prefix=TWO --input-file=%t.early
// RUN: %clipc %s -T vs_5_0 -E instanced -o %t.vert --reflect=%t.instanced && FileCheck %s --check-prefix=TWO --input-file=%t.instanced
// RUN: %clipc %s -T vs_5_0 -E turned -o %t.vert --reflect=%t.turned && FileCheck %s --check-prefix=TWO --input-file=%t.turned
// RUN: %clipc %s -T vs_5_0 -E none -o %t.vert --reflect=%t.none && FileCheck %s --check-prefix=NONE --input-file=%t.none
// RUN: %clipc %s -T vs_5_0 -E by_hand -o %t.vert --reflect=%t.by_hand && FileCheck %s --check-prefix=UNKNOWN --input-file=%t.by_hand
// RUN: %clipc %s -T vs_5_0 -E loop -o %t.vert --reflect=%t.loop && FileCheck %s --check-prefix=UNKNOWN --input-file=%t.loop
// NONE: "positionMatrices": 0
// ONE: "positionMatrices": 1
// TWO: "positionMatrices": 2
// THREE: "positionMatrices": 3
// UNKNOWN: "positionMatrices": null
//
// A remark says so too, where somebody asks for it.
// RUN: %clipc %s -T vs_5_0 -E steps -o %t.vert 2>&1 | count 0
// RUN: %clipc %s -T vs_5_0 -E steps -o %t.vert -Wclip-plane-matrices 2>&1 | FileCheck %s --check-prefix=REMARK
// RUN: %clipc %s -T vs_5_0 -E steps -o %t.vert -Wclip-plane-matrices --plane-space=object 2>&1 | count 0
// RUN: %clipc %s -T vs_5_0 -E one -o %t.vert -Wclip-plane-matrices 2>&1 | count 0
// RUN: %clipc %s -T vs_5_0 -E branches -o %t.vert -Wclip-plane-matrices 2>&1 | count 0
cbuffer Constants : register(b0) {
  float4x4 world, view, projection, world_view_projection;
  float4x4 bones[20];
  float4 matrix_rows[4];
  float4 plane;
  int count;
};

[clipplanes(plane)]
float4 one(float4 p : POSITION) : SV_Position { return mul(p, world_view_projection); }

[clipplanes(plane)]
// REMARK: [[#@LINE+1]]:8: warning: the position is multiplied by 2 matrices, {{.*}} [-Wclip-plane-matrices]
float4 steps(float4 p : POSITION) : SV_Position {
  float4 at = mul(p, world);
  return mul(at, view);
}

float4 product(float4 p : POSITION) : SV_Position { return mul(p, mul(world, view)); }

float4 rows_of(float4 p, float4x4 m) { return p.x * m[0] + p.y * m[1] + p.z * m[2] + p.w * m[3]; }
float4 rows(float4 p : POSITION) : SV_Position { return rows_of(rows_of(p, world), view); }

float4 branches(float4 p : POSITION) : SV_Position {
  if (count > 0) {
    p = mul(p, world);
  }
  return mul(p, count > 1 ? view : projection);
}

float4 called(float4 p : POSITION) : SV_Position {
  p = mul(p, world), p = mul(p, view);
  p.xy += 0.5 * p.w;
  return mul(projection, p);
}

struct Skin {
  float4 position : POSITION;
  float4 weights : WEIGHTS;
  uint4 indices : INDICES;
};
float4 skinned(Skin skin) : SV_Position {
  float3 p = 0;
  for (int i = 0; i < 4; ++i) p += skin.weights[i] * mul(skin.position, bones[skin.indices[i]]).xyz;
  return mul(float4(p, 1), world_view_projection);
}

// Another output passes through more.
struct Output {
  float4 position : SV_Position;
  float4 shadow : TEXCOORD0;
};
Output fields(float4 p : POSITION) {
  Output output;
  output.shadow = mul(mul(p, world), view);
  output.position = mul(p, world_view_projection);
  return output;
}

float4 early(float4 p : POSITION) : SV_Position {
  if (count == 3) return mul(mul(p, world), view);
  return mul(p, world_view_projection);
}

float4 instanced(float4 p : POSITION, float4x4 place : PLACE) : SV_Position { return mul(mul(p, place), view); }

// A matrix that the shader makes.
float4 turned(float4 p : POSITION, float angle : ANGLE) : SV_Position {
  float2x2 turn = {cos(angle), sin(angle), -sin(angle), cos(angle)};
  p.xy = mul(p.xy, turn);
  return mul(p, world_view_projection);
}

float4 none(float4 p : POSITION) : SV_Position { return p * 2; }

float4 by_hand(float4 p : POSITION) : SV_Position {
  return float4(dot(p, matrix_rows[0]), dot(p, matrix_rows[1]), dot(p, matrix_rows[2]), 1);
}

float4 loop(float4 p : POSITION) : SV_Position {
  for (int i = 0; i < count; ++i) p = mul(p, bones[i]);
  return p;
}
