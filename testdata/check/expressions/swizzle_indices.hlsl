// A component of a swizzle that is chosen at run time is assigned to; the index is computed once.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 -E main --ints 0..3
// RUN: %draw compare %s -T vs_5_0 -E main --ints 0..3 --target glsl120,essl100
int n;  // one of --ints
static int calls = 0;
int Next() { return calls++; }
void Set(out float x, float value) { x = value; }
struct Output {
  float4 position : SV_Position;
  float4 a : A;
};
// CHECK: entry
Output main(float4 p : POSITION) {
  Output o;
  o.position = p;
  // CHECK: o.position[int4(3, 2, 1, 0)[n]] = p.x
  o.position.wzyx[n] = p.x;
  o.a = p * 2;
  // CHECK: o.a[int3(2, 0, 1)[Next()]] += 1.0
  o.a.zxy[Next()] += 1;
  o.a.zxy[Next()] -= 2;
  // CHECK: o.a[int2(3, 1)[n / 2]]++
  o.a.wy[n / 2]++;
  int4 whole = int4(p * 8);
  // CHECK: int temporary = int4(1, 0, 3, 2)[Next()]
  // CHECK-NEXT: whole[temporary] =
  whole.yxwz[Next()] *= 1.5;
  float4x4 m = 0;
  m[1].yx[n / 2] = 3;
  m[n].yx[1 - (n / 2)] = 4;
  Set(o.a.ywzx[n], calls);
  // CHECK: modf(p.x * 4.0, o.a[int3(1, 3, 2)[n % 3]])
  o.a.x += modf(p.x * 4, o.a.ywz[n % 3]);
  o.a += whole + m[1] + m[2] + m[3];
  return o;
}
