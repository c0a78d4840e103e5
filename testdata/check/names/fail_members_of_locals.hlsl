// RUN: not %clipc %s -o %t.vert 2>&1 | FileCheck %s
// An unknown name that is a member of a parameter, of a local variable or of an array's elements; and a member of an array, whose
// elements have it.
struct Light { float4 color; float strength; };
struct Vertex { float4 position : POSITION; float2 place : TEXCOORD; };
cbuffer Lights { Light lights[4]; Light grid[2][3]; float4 rows[3]; };

float Sum(Light light) {
  // CHECK: [[#@LINE+1]]:10: error: `strength` is not declared; did you mean `lights[i].strength`, `grid[i][j].strength`, `light.strength`? [undeclared-name, X3004]
  return strength;
}

float4 main(Vertex vertex) : SV_Position {
  Light strongest = lights[0];
  // CHECK: [[#@LINE+1]]:14: error: `place` is not declared; did you mean `vertex.place`? [undeclared-name, X3004]
  float2 a = place;
  // CHECK: [[#@LINE+1]]:21: error: `Light[4]` has no member `color`; each element has it, `lights[i].color` [no-such-member, X3018]
  float4 b = lights.color;
  // CHECK: [[#@LINE+1]]:19: error: `Light[2][3]` has no member `color`; each element has it, `grid[i][j].color` [no-such-member, X3018]
  float4 c = grid.color;
  // CHECK: [[#@LINE+1]]:19: error: `float4[3]` has no member `xy`; each element has it, `rows[i].xy` [no-such-member, X3018]
  float2 d = rows.xy;
  // CHECK: [[#@LINE+1]]:19: error: `float4[3]` has no member `none` [no-such-member, X3018]
  float2 e = rows.none;
  // CHECK: [[#@LINE+1]]:3: error: `Float4` is not a type; did you mean `float4`? [unknown-type, X3000]
  Float4 f = 0;
  // CHECK: [[#@LINE+1]]:3: error: `Texure2D` is not a type; did you mean `Texture2D`{{.*}} [unknown-type, X3000]
  Texure2D g;
  return b + c + Sum(strongest) + float4(a + d + e, 0, 0) + f;
}
