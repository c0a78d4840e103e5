// A semantic on a struct overrides those of its fields, and nothing else that the fields say.
// RUN: %clipc -T vs_5_0 --validate %s -o - 2>%t.err | FileCheck %s
// RUN: FileCheck %s --input-file=%t.err --check-prefix=SAID
// RUN: %clipc -T vs_5_0 -E places --validate %s -o - | FileCheck %s --check-prefix=PLACES
// RUN: %clipc -T vs_5_0 -E joined --validate %s -o - | FileCheck %s --check-prefix=JOINED

struct Fields {
  nointerpolation float4 a : COLOR3;
  // SAID: :[[#@LINE+1]]:37: warning: `fields.b` is `COLOR4`, not `TANGENT0`: a semantic on the whole overrides those of its fields [-Wsemantic-overridden]
  noperspective centroid float4 b : TANGENT;
  precise float4 c;
  struct { sample float4 a; } d;
  float4 e : color7;
};
// SAID-NOT: warning

// CHECK: layout(location = 0) flat out vec4 vs_COLOR3;
// CHECK-NEXT: layout(location = 1) noperspective centroid out vec4 vs_COLOR4;
// CHECK-NEXT: layout(location = 2) precise out vec4 vs_COLOR5;
// CHECK-NEXT: layout(location = 3) sample out vec4 vs_COLOR6;
// CHECK-NEXT: layout(location = 4) out vec4 vs_COLOR7;
float4 main(float4 p : POSITION, out Fields fields : COLOR3) : SV_Position {
  fields = (Fields)p.x;
  return p;
}

struct Places { centroid float4 a : A; [[vk::location(5)]] float4 b : B; float4 c : C; };

// PLACES: layout(location = 2) sample out vec4 vs_A0;
// PLACES-NEXT: layout(location = 5) sample out vec4 vs_B0;
// PLACES-NEXT: layout(location = 6) sample out vec4 vs_C0;
float4 places(float4 p : POSITION, [[vk::location(2)]] out sample Places q) : SV_Position {
  q = (Places)p.x;
  return p;
}

// The modifiers of the struct and of its field are joined; `nointerpolation` comes first, as vkd3d's
// test of it has it, which passes on Microsoft's compiler.
struct Modes {
  centroid linear float4 a : A;
  noperspective float4 b : B;
};

// JOINED: layout(location = 0) flat out vec4 vs_A0;
// JOINED-NEXT: layout(location = 1) flat out vec4 vs_B0;
float4 joined(float4 p : POSITION, out nointerpolation Modes modes) : SV_Position {
  modes = (Modes)p.x;
  return p;
}
