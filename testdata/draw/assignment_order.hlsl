// The value of an assignment is found before the place of its target, as by dxc (SpirvEmitter's doBinaryOperator), where one changes what the other reads.
// RUN: %draw compare %s -T vs_6_0
// RUN: %clipc %s -T vs_6_0 -o - | FileCheck %s
// RUN: %clipc %s -T cs_6_0 -E compute -o - | FileCheck %s --check-prefix=CS
struct S { float v[4]; uint i; };
static uint count;
float Bump(inout S s) { s.i = s.i + 1; return s.i; }
uint Next() { return ++count; }
float4 main(float4 p : P, uint i : I) : SV_Position {
  uint a[8] = {0, 0, 0, 0, 0, 0, 0, 0};
  uint n = i & 1, k = 0, q = 1;
  // CHECK: uint [[FIRST:[a-z_0-9]+]] = n;
  // CHECK-NEXT: a[n++] = [[FIRST]];
  a[n++] = n;
  float4 v = p;
  // CHECK: = v.x++ + float(k++);
  // CHECK-NEXT: v[k & 1u] =
  v[k & 1] = v.x++ + k++;
  S s = {{1, 2, 3, 4}, 0};
  // CHECK: = Bump(s);
  // CHECK-NEXT: s.v[s.i] =
  s.v[s.i] = Bump(s);
  float b[4] = {1, 2, 3, 4};
  int j = 0;
  b[j] = j = 2;
  // CHECK: [[ADDED:[a-z_0-9]+]] = q;
  // CHECK-NEXT: a[q++] += [[ADDED]];
  a[q++] += q;
  // CHECK: = 1u + Next();
  // CHECK-NEXT: a[4u + (Next() & 3u)] =
  a[4 + (Next() & 3)] = 1 + Next();
  // What does not matter stays as it is.
  // CHECK: a[n++] = uint(saturate(in_P0.x) * 9.0);
  // CHECK-NEXT: a[k++ & 1u] = Next();
  // CHECK-NEXT: v[count & 1u] = 7.0;
  a[n++] = saturate(p.x) * 9;
  a[k++ & 1] = Next();
  v[count & 1] = 7;
  float2x2 m[2] = {1, 2, 3, 4, 5, 6, 7, 8};
  int w = 0;
  m[w++]._m00_m11 = w + 10;
  float4 sum = float4(a[0] + a[3], a[1] + a[4], a[2] + a[5], n + a[6] + a[7]);
  return sum + v + float4(s.v[0], s.v[1], b[0], b[2]) + m[0]._m00_m01_m10_m11 + k + q;
}
RWStructuredBuffer<uint> o;
RWTexture2D<uint> t;
// CS: uint [[ONE:[a-z_0-9]+]] = n;
// CS-NEXT: o[n++] = [[ONE]];
// CS-NEXT: uint [[TWO:[a-z_0-9]+]] = n;
// CS-NEXT: imageStore(t, ivec2(uvec2(n++, 0u)), uvec4([[TWO]], 0u, 0u, 0u));
// CS-NEXT: o[n++] = 5u;
[numthreads(1, 1, 1)] void compute(uint id : SV_DispatchThreadID) {
  uint n = id;
  o[n++] = n;
  t[uint2(n++, 0)] = n;
  o[n++] = 5;
}
