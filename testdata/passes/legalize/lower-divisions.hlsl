// The least integer divided by -1 is itself in Direct3D, and the remainder is 0. Mesa's compiler ends at such constants, so that GLSL
// gets none. Oracle: vkd3d's arithmetic-int.shader_test, line 95, checked against fxc.
// RUN: %clipc -T vs_5_0 --verify %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// RUN: %clipc -T vs_5_0 -E others --verify %s -o - | FileCheck --check-prefix=OTHERS %s

// CHECK-DAG: int modulo(int x, int y) {{{[[:space:]]+}}return y == 0 ? x < 0 ? 1 : -1 : imod(x, y == -1 ? 1 : y == 0 ? 1 : y);
// CHECK-DAG: int divide(int x, int y) {{{[[:space:]]+}}return y == 0 ? x < 0 ? 1 : -1 : y == -1 ? -x : x / (y == -1 ? 1 : y == 0 ? 1 : y);
// CHECK-DAG: ivec2 divide(ivec2 x, ivec2 y) {{{[[:space:]]+}}return mix(mix(x / mix(mix(y, ivec2(1), equal(y, ivec2(0))), ivec2(1), equal(y, ivec2(-1))), -x, equal(y, ivec2(-1))), mix(ivec2(-1), ivec2(1), lessThan(x, ivec2(0))), equal(y, ivec2(0)));
// CHECK: ivec2 z = ivec2(int(0x80000000u), 3) + divide(ivec2(x, 7), ivec2(y, 2));
// CHECK-NEXT: x = modulo(x, y);
// CHECK: x = divide(x, y);
// CHECK: vec4(float(divide(x, y)), float(x / 2), float(-x), float(divide(x, in_W0)))
float4 main(int w : W) : SV_Position {
  int x = 0x80000000, y = -1;
  int2 z = int2(0x80000000, 7) / int2(-1, 2) + int2(x, 7) / int2(y, 2);
  x %= y;
  x |= 0x80000000;
  x /= y;
  return float4(x / y, x / 2, x / -1, x / w) + z.xxyy;
}

// Where no such constant is, a choice of scalars may have an operand that is not computed.
// OTHERS: return y == 0 ? x < 0 ? 1 : -1 : y == -1 ? -x : x / y;
// OTHERS: divide(in_W0, y)
// OTHERS: -in_W0
// OTHERS: imod(in_W0, 1)
float4 others(int w : W) : SV_Position {
  int y = w + 1;
  return float4(w / y, w / -1, w % -1, 1);
}
