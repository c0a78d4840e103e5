// HLSL 2021: templates of functions and structs, operators.
// RUN: %clipc -T vs_6_6 -E main --dump=ir %s | FileCheck %s
template<typename T> T twice(T x) { return x + x; }
template<typename T, int N> T times(T x) { return x * N; }
template<typename T, uint N> vector<T, N> reversed(vector<T, N> x) { return x.yx; }
template<typename T, int N = 2> struct Stack {
  T items[N];
  T top() { return items[N - 1]; }
};
struct Complex {
  float2 v;
  Complex operator*(Complex o) { Complex r; r.v = float2(v.x * o.v.x - v.y * o.v.y, v.x * o.v.y + v.y * o.v.x); return r; }
};
Complex operator+(Complex a, Complex b) { Complex r; r.v = a.v + b.v; return r; }
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK: float4 a = twice(p)
  float4 a = twice(p);
  // CHECK: float b = twice.1(p.x)
  float b = twice(p.x) + twice<float>(1);
  // CHECK: float c = times(b)
  float c = times<float, 3>(b);
  // CHECK: float2 d = reversed(p.xy)
  float2 d = reversed(p.xy);
  Stack<float2> e = {1, 2, 3, 4};
  // CHECK: d += top(e)
  d += e.top();
  Complex f = {1, 2}, g = {3, 4};
  // CHECK: operator+(operator*(f, g), f)
  Complex h = f * g + f;
  return a * b * c + d.xyxy + h.v.xyxy;
}
// CHECK: float4 twice(float4
// CHECK: float twice.1(float
// CHECK: float times(float
// CHECK-NEXT: * 3.0
