// The reflection says which matrices the position is multiplied by, and in which order: the application knows which of them is
// far from the origin, and DrawMatrices::order of the runtime asks for it.
//
// RUN: %clipc %s -T vs_5_0 -E world_view_first -o %t.vert --reflect=%t.a && FileCheck %s --check-prefix=WORLD-VIEW --input-file=%t.a
// RUN: %clipc %s -T vs_5_0 -E in_the_shader -o %t.vert --reflect=%t.b && FileCheck %s --check-prefix=PRODUCT --input-file=%t.b
// RUN: %clipc %s -T vs_5_0 -E columns -o %t.vert --reflect=%t.c && FileCheck %s --check-prefix=COLUMNS --input-file=%t.c
// RUN: %clipc %s -T vs_5_0 -E member -o %t.vert --reflect=%t.d && FileCheck %s --check-prefix=MEMBER --input-file=%t.d
// RUN: %clipc %s -T vs_5_0 -E offset -o %t.vert --reflect=%t.e && FileCheck %s --check-prefix=OFFSET --input-file=%t.e
// RUN: %clipc %s -T vs_5_0 -E either -o %t.vert --reflect=%t.f && FileCheck %s --check-prefix=UNKNOWN --input-file=%t.f
// RUN: %clipc %s -T vs_5_0 -E by_hand -o %t.vert --reflect=%t.g && FileCheck %s --check-prefix=UNKNOWN --input-file=%t.g
// RUN: %clipc %s -T vs_5_0 -E repeated -o %t.vert --reflect=%t.k && FileCheck %s --check-prefix=REPEATED --input-file=%t.k
// RUN: %clipc %s -T vs_5_0 -E row -o %t.vert --reflect=%t.i && FileCheck %s --check-prefix=UNKNOWN --input-file=%t.i
// RUN: %clipc %s -T vs_5_0 -E twice -o %t.vert --reflect=%t.j && FileCheck %s --check-prefix=TWICE --input-file=%t.j
// WORLD-VIEW: "positionMatrices": 2
// WORLD-VIEW-NEXT: "positionProduct": "mul(mul(v, world_view), projection)"
// PRODUCT: "positionProduct": "mul(v, mul(world, view_projection))"
// COLUMNS: "positionProduct": "mul(projection, mul(view, mul(places[], v)))"
// MEMBER: "positionProduct": "mul(mul(v, world), camera.view_projection)"
// OFFSET: "positionProduct": "mul(mul(v, world), view_projection)"
// UNKNOWN: "positionMatrices": 2
// UNKNOWN-NEXT: "positionProduct": null
// REPEATED: "positionMatrices": null
// REPEATED-NEXT: "positionProduct": null
// TWICE: "positionProduct": "mul(mul(v, world), view)"
cbuffer Draw : register(b0) {
  float4x4 world, world_view, view, projection, view_projection;
  float4x4 places[8];
  int count;
};
struct Camera {
  float4 eye;
  float4x4 view_projection;
};
Camera camera;

float4 world_view_first(float4 p : POSITION) : SV_Position { return mul(mul(p, world_view), projection); }
float4 in_the_shader(float4 p : POSITION) : SV_Position { return mul(p, mul(world, view_projection)); }
float4 columns(float4 p : POSITION, uint i : SV_InstanceID) : SV_Position { return mul(projection, mul(view, mul(places[i], p))); }
float4 member(float3 p : POSITION) : SV_Position {
  float3 at = mul(float4(p, 1), world).xyz;
  return mul(float4(at, 1), camera.view_projection);
}
float4 offset(float4 p : POSITION) : SV_Position {
  float4 at = mul(p * 2, world) - camera.eye;
  at.y += sin(at.x);
  return 0.5 * mul(at, view_projection);
}
float4 either(float4 p : POSITION) : SV_Position {
  if (count > 0) return mul(mul(p, world), view);
  return mul(mul(p, world), projection);
}
float4 by_hand(float4 p : POSITION) : SV_Position {
  p = mul(p, world);
  return p.x * view[0] + p.y * view[1] + p.z * view[2] + p.w * view[3];
}
float4 repeated(float4 p : POSITION) : SV_Position {
  for (int i = 0; i < count; ++i) p = mul(p, world);
  return p;
}
float4 row(float4 p : POSITION) : SV_Position {
  p = mul(p, world);
  p.w = dot(p, view[3]);
  return p;
}
// A function that is called twice; the first value is not the position's.
float4 to_world(float4 p) { return mul(p, world); }
float4 twice(float4 p : POSITION, out float4 shadow : TEXCOORD0) : SV_Position {
  shadow = mul(to_world(p), projection);
  return mul(to_world(p), view);
}
