// A choice between arrays is made by statements on Vulkan: SPIR-V before 1.4 selects scalars and vectors only, and glslang takes an
// array of vectors for one. So it is in WebGL 1, where arrays that are values are structs, and GLSL ES 1.00 has no choice between
// these. Other targets have the choice as it is.
// RUN: %clipc %s -T vs_5_0 --target=vulkan --verify --validate -o - | FileCheck %s
// RUN: %clipc %s -T vs_5_0 -spirv -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc %s -T vs_5_0 --target=glsl450 --validate -o - | FileCheck %s --check-prefix=OPENGL
// RUN: %clipc %s -T vs_5_0 --target=webgl1 --validate -o - | FileCheck %s --check-prefix=WEBGL
// RUN: %draw compare %s -T vs_5_0 --target vulkan,glsl450,essl100
// OPENGL-NOT: choose
// WEBGL-NOT: {{ \? }}
// WEBGL: Rows p = choose({{.*}}, n, m);
// WEBGL-NOT: {{ \? }}
struct Rows { int2x4 rows; float4 places[2]; };
// CHECK: ivec4[2] choose(bool condition, ivec4 a[2], ivec4 b[2]) {
// CHECK-NEXT: if (condition) {
// CHECK-NEXT: return a;
// CHECK-NEXT: }
// CHECK-NEXT: return b;
float4 main(int2x4 a : POSITION, float4 q : OTHER) : SV_Position {
  int2x4 b = int2x4(1, 2, 3, 4, 5, 6, 7, 8);
  float4 x[2] = {q, q.wzyx}, y[2] = {q.yyyy, q.zzzz};
  int2x4 c = q.x > 0 ? a : b;
  int2x4 d = q.y > 0 ? (int2x4)0 : int2x4(8, 7, 6, 5, 4, 3, 2, 1);
  float4 z[2] = q.z > 0 ? x : y;
  Rows m = {a, x}, n = {b, y};
  Rows p = q.w > 1 ? n : m;
  return c[0] + d[1] + z[0] + z[1].yxwz + p.rows[1] + p.places[0];
}
