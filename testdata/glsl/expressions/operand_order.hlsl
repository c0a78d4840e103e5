// An operand that a later one may change is read before it. Oracle: dxc, which evaluates operands, arguments and the parts of
// constructors from left to right (CGExprScalar.cpp, EmitBinOps: the left side is visited first; CGCall.cpp, EmitCallArgs).
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
static int n = 1;
static float4x4 m = { 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4 };
int f(int k) {
  n = n * 10 + k;
  return k;
}
int add(inout int a) {
  a += 5;
  return 1;
}
int digits(int a, int b, int c) { return a * 100 + b * 10 + c; }
float4 turn() {
  m[0][1] += 1;
  return m[0];
}
struct Counter {
  int k;
  int next() {
    k += 1;
    return k;
  }
};
struct Out {
  float4 position : SV_Position;
  int4 a : A, b : B, c : C, d : D;
  float4 e : E;
};
Out main(int4 p : POSITION, float4 v : V) {
  Out o;
  // CHECK: int old_n = n;
  // CHECK-NEXT: int r = old_n + f(2);
  int r = n + f(2);
  int i = p.x;
  // CHECK: int old_i = i;
  // CHECK-NEXT: vs_A0 = ivec4(old_i, add(i), i, r);
  o.a = int4(i, add(i), i, r);
  // CHECK: int old_i_2 = i;
  // CHECK-NEXT: vs_B0 = ivec4(digits(old_i_2, i++, i));
  o.b = digits(i, i++, i);
  Counter s;
  s.k = p.y;
  // CHECK: int old_k = s.k;
  // CHECK-NEXT: vs_C0 = ivec4(old_k, next(s), s.k, 0);
  o.c = int4(s.k, s.next(), s.k, 0);
  // A read that is not the first thing a statement does, and one in a loop.
  // CHECK: vs_D0.x = f(1) + (old_n_2 = n) * f(3);
  o.d.x = f(1) + n * f(3);
  // CHECK: while ((old_n_3 = n) + f(1) < 20000) {
  while (n + f(1) < 20000) r += 1;
  // The place in an array, and the value of an assignment.
  int a[4] = { 1, 2, 3, 4 };
  int at = 0;
  // CHECK: vs_D0.y = a[old_at] + a[old_at_2 = at = 2] * (at = 3);
  o.d.y = a[at] + a[at = 2] * (at = 3);
  // CHECK: vs_D0.z = n;
  o.d.z = n;
  // CHECK: vs_D0.w = r;
  o.d.w = r;
  // mul() and select() are written with their operands in the opposite order.
  // CHECK: vs_E0 = (value = turn(), m * value);
  o.e = mul(turn(), m);
  // CHECK: vs_E0 += (value_2 = greaterThan(v, vec4(0.0)), (value_3 = v, mix(v = v * 2.0, value_3, value_2)));
  o.e += (v > 0) ? v : (v = v * 2);
  // A compound assignment reads its target last (CGExprScalar.cpp, EmitCompoundAssignLValue: the right side is emitted first).
  float2x2 small = { 1, 2, 3, 4 };
  // CHECK: value_4 = small = mat2(v.x, 0.0, 0.0, 2.0), small = matrixCompMult(small, value_4);
  small *= small = float2x2(v.x, 0, 0, 2);
  o.e += float4(small[0], small[1]);
  // CHECK: index = at, value_5 = (a[0] = in_POSITION0.y & 3) + 2, a[index] = modulo(a[index], value_5);
  a[at] %= (a[0] = p.y & 3) + 2;
  o.b.x += a[0] + a[3];
  // The index of an only row is evaluated in its place.
  int1x1 ones[2] = { p.x, p.y };
  // CHECK: vs_B0.y += ones[first((old_at_3 = at = 1) & 1, (at = 3 - at) & 0)];
  o.b.y += ones[(at = 1) & 1][(at = 3 - at) & 0];
  // CHECK: int [[LAST:[a-z_0-9]+]] = at;
  // CHECK: ones[first((old_at_4 = at = 2) & 1, (at = 5 - at) & 0)] = [[LAST]];
  ones[(at = 2) & 1][(at = 5 - at) & 0] = at;
  o.b.z += ones[0][0] + at;
  o.position = v;
  return o;
}
