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
// RUN: %clipc %s -T vs_5_0 -E whole_again -o %t.vert --reflect=%t.whole_again && FileCheck %s --check-prefix=ONE --input-file=%t.whole_again
// RUN: %clipc %s -T vs_5_0 -E listed -o %t.vert --reflect=%t.listed && FileCheck %s --check-prefix=ONE --input-file=%t.listed
// RUN: %clipc %s -T vs_5_0 -E chosen -o %t.vert --reflect=%t.chosen && FileCheck %s --check-prefix=TWO --input-file=%t.chosen
// RUN: %clipc %s -T vs_5_0 -E chosen_second -o %t.vert --reflect=%t.chosen_second && FileCheck %s --check-prefix=TWO --input-file=%t.chosen_second
// RUN: %clipc %s -T vs_5_0 -E by_component -o %t.vert --reflect=%t.by_component && FileCheck %s --check-prefix=TWO --input-file=%t.by_component
// RUN: %clipc %s -T vs_6_0 -E effect_of_choice -o %t.vert --reflect=%t.effect_of_choice && FileCheck %s --check-prefix=TWO --input-file=%t.effect_of_choice
// RUN: %clipc %s -T vs_5_0 -E comma -o %t.vert --reflect=%t.comma && FileCheck %s --check-prefix=TWO --input-file=%t.comma
// RUN: %clipc %s -T vs_5_0 -E constant -o %t.vert --reflect=%t.constant && FileCheck %s --check-prefix=TWO --input-file=%t.constant
// RUN: %clipc %s -T vs_5_0 -E mads -o %t.vert --reflect=%t.mads && FileCheck %s --check-prefix=TWO --input-file=%t.mads
// RUN: %clipc %s -T vs_5_0 -E dots -o %t.vert --reflect=%t.dots && FileCheck %s --check-prefix=TWO --input-file=%t.dots
// RUN: %clipc %s -T vs_5_0 -E stored -o %t.vert --reflect=%t.stored && FileCheck %s --check-prefix=TWO --input-file=%t.stored
// RUN: %clipc %s -T vs_5_0 -E out_argument -o %t.vert --reflect=%t.out_argument && FileCheck %s --check-prefix=TWO --input-file=%t.out_argument
// RUN: %clipc %s -T vs_5_0 -E modf_argument -o %t.vert --reflect=%t.modf_argument && FileCheck %s --check-prefix=TWO --input-file=%t.modf_argument
// RUN: %clipc %s -T vs_5_0 -E scaled -o %t.vert --reflect=%t.scaled && FileCheck %s --check-prefix=TWO --input-file=%t.scaled
// RUN: %clipc %s -T vs_5_0 -E added -o %t.vert --reflect=%t.added && FileCheck %s --check-prefix=TWO --input-file=%t.added
// RUN: %clipc %s -T vs_5_0 -E part -o %t.vert --reflect=%t.part && FileCheck %s --check-prefix=TWO --input-file=%t.part
// RUN: %clipc %s -T vs_5_0 -E cases -o %t.vert --reflect=%t.cases && FileCheck %s --check-prefix=TWO --input-file=%t.cases
// RUN: %clipc %s -T vs_5_0 -E no_case -o %t.vert --reflect=%t.no_case && FileCheck %s --check-prefix=TWO --input-file=%t.no_case
// RUN: %clipc %s -T vs_5_0 -E broken -o %t.vert --reflect=%t.broken && FileCheck %s --check-prefix=TWO --input-file=%t.broken
// RUN: %clipc %s -T vs_5_0 -E continued -o %t.vert --reflect=%t.continued && FileCheck %s --check-prefix=TWO --input-file=%t.continued
// RUN: %clipc %s -T vs_5_0 -E not_once -o %t.vert --reflect=%t.not_once && FileCheck %s --check-prefix=TWO --input-file=%t.not_once
// RUN: %clipc %s -T vs_5_0 -E stepped -o %t.vert --reflect=%t.stepped && FileCheck %s --check-prefix=TWO --input-file=%t.stepped
// RUN: %clipc %s -T vs_5_0 -E left -o %t.vert --reflect=%t.left && FileCheck %s --check-prefix=TWO --input-file=%t.left
// RUN: %clipc %s -T vs_5_0 -E in_struct -o %t.vert --reflect=%t.in_struct && FileCheck %s --check-prefix=TWO --input-file=%t.in_struct
// RUN: %clipc %s -T vs_5_0 -E beside_in_struct -o %t.vert --reflect=%t.beside_in_struct && FileCheck %s --check-prefix=ONE --input-file=%t.beside_in_struct
// RUN: %clipc %s -T vs_5_0 -E asked -o %t.vert --reflect=%t.asked && FileCheck %s --check-prefix=TWO --input-file=%t.asked
// RUN: %clipc %s -T vs_5_0 -E out_early -o %t.vert --reflect=%t.out_early && FileCheck %s --check-prefix=TWO --input-file=%t.out_early
// NONE: "positionMatrices": 0
// ONE: "positionMatrices": 1
// TWO: "positionMatrices": 2
// THREE: "positionMatrices": 3
// UNKNOWN: "positionMatrices": null
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

struct Camera {
  float4x4 view;
  float4 eye;
};
Camera camera;
float4 in_struct(float4 p : POSITION) : SV_Position { return mul(mul(p, world), camera.view); }
float4 beside_in_struct(float4 p : POSITION) : SV_Position { return mul(p - camera.eye, view); }

float4 whole_again(float4 p : POSITION) : SV_Position {
  float4 at = mul(p, world);
  at = p;
  return mul(at, view);
}

Output listed(float4 p : POSITION) {
  Output output = {mul(p, world_view_projection), mul(mul(p, world), view)};
  return output;
}

float4 chosen(float4 p : POSITION) : SV_Position { return mul(count > 0 ? p : mul(p, world), view); }
float4 chosen_second(float4 p : POSITION) : SV_Position { return mul(count > 0 ? mul(p, world) : p, view); }
float4 by_component(float4 p : POSITION) : SV_Position { return mul(p > 0 ? p : mul(p, world), view); }
float4 effect_of_choice(float4 p : POSITION) : SV_Position {
  float4 at = p;
  float x = count > 0 ? (at = mul(p, world)).x : p.y;
  return mul(at, view) + x;
}

float4 comma(float4 p : POSITION) : SV_Position {
  float4 at;
  return (at = mul(p, world), mul(at, view));
}

static const float4x4 kTurn = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
float4 constant(float4 p : POSITION) : SV_Position { return mul(mul(p, kTurn), view); }

float4 mad_of(float4 p, float4x4 m) { return mad(p.x, m[0], mad(p.y, m[1], mad(p.z, m[2], m[3]))); }
float4 mads(float4 p : POSITION) : SV_Position { return mad_of(mad_of(p, world), view); }

float4 dots_of(float4 p, float4x4 m) { return float4(dot(p, m[0]), dot(p, m[1]), dot(p, m[2]), dot(p, m[3])); }
float4 dots(float4 p : POSITION) : SV_Position { return dots_of(dots_of(p, world), view); }

StructuredBuffer<float4x4> places;
float4 stored(float4 p : POSITION) : SV_Position { return mul(mul(p, places[count]), view); }

void move(float4 from, out float4 to) { to = mul(from, world); }
float4 out_argument(float4 p : POSITION) : SV_Position {
  float4 at;
  move(p, at);
  return mul(at, view);
}
float4 modf_argument(float4 p : POSITION) : SV_Position {
  float4 at;
  modf(mul(p, world), at);
  return mul(at, view);
}

float4 scaled(float4 p : POSITION) : SV_Position {
  p = mul(p, world);
  p *= view[0];
  return p;
}
float4 added(float4 p : POSITION) : SV_Position {
  float4 at = mul(p, world);
  at += 1;
  return mul(at, view);
}
float4 part(float4 p : POSITION) : SV_Position {
  float4 at = mul(p, world);
  at.x = 0;
  return mul(at, view);
}

float4 cases(float4 p : POSITION) : SV_Position {
  switch (count) {
    case 0: p = mul(p, world); break;
    default: p = 0; break;
  }
  return mul(p, view);
}
float4 no_case(float4 p : POSITION) : SV_Position {
  float4 at = mul(p, world);
  switch (count) {
    case 0: at = p; break;
  }
  return mul(at, view);
}

float4 broken(float4 p : POSITION) : SV_Position {
  float4 at = p;
  for (int i = 0; i < count; ++i) {
    if (i == 1) {
      at = mul(p, world);
      break;
    }
    at = p;
  }
  return mul(at, view);
}
float4 continued(float4 p : POSITION) : SV_Position {
  float4 at = p;
  for (int i = 0; i < count; ++i) {
    if (i == 1) {
      at = mul(p, world);
      continue;
    }
    at = p;
  }
  return mul(at, view);
}
float4 not_once(float4 p : POSITION) : SV_Position {
  float4 at = mul(p, world);
  for (int i = 0; i < count; ++i) at = p;
  return mul(at, view);
}
float4 stepped(float4 p : POSITION) : SV_Position {
  float4 at = p;
  for (int i = 0; i < count; at = mul(p, world), ++i) at = p;
  return mul(at, view);
}
float4 left(float4 p : POSITION) : SV_Position {
  for (int i = 0; i < count; ++i) {
    if (i == 7) return mul(mul(p, world), view);
  }
  return mul(p, world_view_projection);
}
float4 asked(float4 p : POSITION) : SV_Position {
  float4 at = p;
  while ((at = mul(p, world)).x > 0) {
    if (count > 0) return mul(at, view);
    break;
  }
  return mul(at, view);
}
void move_early(float4 from, out float4 to) {
  to = mul(from, world);
  if (count > 0) return;
  to = from;
}
float4 out_early(float4 p : POSITION) : SV_Position {
  float4 at;
  move_early(p, at);
  return mul(at, view);
}
