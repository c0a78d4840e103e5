// Explicit and partial specialisations are what a template means for their arguments, as in C++ and dxc: f<int>(5) is 15. Which
// struct is meant does not depend on how its arguments are spelled, and a static method is called by the struct's name.
// RUN: %clipc -T vs_6_2 --target=glsl450 --validate %s -o - | FileCheck %s
template<typename T> T f(T x) { return x * 2; }
template<> int f<int>(int x) { return x * 3; }
template<> float f(float x) { return x * 5; }
template<typename T> struct Traits { static float Size() { return 1; } static Traits Make() { Traits t; t.value = 1; return t; } T value; };
template<> struct Traits<float3> { static float Size() { return 3; } static Traits Make() { Traits t; t.wide = 2; return t; } float wide; };
template<typename T, int N = 4> struct Box { static float Kind() { return 1; } };
template<typename T> struct Box<T, 2> { static float Kind() { return 2; } T two; };
template<int N> struct Box<float, N> { static float Kind() { return 10 + N; } };
template<typename T, int N> struct Box<vector<T, N>, 3> { static float Kind() { return 20 + N; } };
// The most special one that fits is meant, [temp.class.order] of C++: a float2 is a vector<T, 2> first.
template<typename T, typename U> struct Pair { static const int kKind = 1; };
template<typename T> struct Pair<T, T> { static const int kKind = 2; };
template<typename T, int N> struct Pair<vector<T, N>, vector<T, N> > { static const int kKind = 3; };
template<typename T> struct Pair<vector<T, 2>, vector<T, 2> > { static const int kKind = 4; };
template<typename T> struct Pair<T, int> { static const int kKind = 5; };
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK: int f(int x) {
  // CHECK-NEXT: return x * 3;
  // CHECK: float f(float x) {
  // CHECK-NEXT: return x * 5.0;
  // CHECK: uint f(uint x) {
  // CHECK-NEXT: return x * 2u;
  float4 r = float4(f<int>(5), f(p.x), f<float>(p.y), f(2u));
  r.x += Traits<vector<float, 3> >::Size() + Traits<float3>::Make().wide + Traits<int>::Make().value;
  // The kinds are 1, 2, 17, 14 and 22.
  r.y += Box<int>::Kind() + 10 * Box<int, 2>::Kind() + Box<float, 7>::Kind() * 100 + Box<float>::Kind() * 10000;
  r.z += Box<int2, 3>::Kind();
  // The kinds are 1, 2, 3, 4 and 5.
  r.w += Pair<float, uint>::kKind + 10 * Pair<uint, uint>::kKind + 100 * Pair<int3, int3>::kKind + 1000 * Pair<float2, float2>::kKind +
         10000 * Pair<float, int>::kKind;
  return r;
}
// RUN: %draw compare %s -T vs_6_2
