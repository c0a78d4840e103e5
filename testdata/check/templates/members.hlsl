// The arguments of a template of a struct are values too, and `L<T>::v` is the field or method of a base.
// RUN: %clipc %s -T ps_6_0 -o - | FileCheck %s
// RUN: %draw compare %s -T ps_6_0
struct A {
  float x;
  template<int K> float q() { return x * K; }
};
template<typename T> struct L {
  T v;
  T Get() { return v; }
  void Double() { L<T>::v *= 2; }
};
struct Base {
  float x;
};
struct Derived : Base {
  // CHECK: void Set(inout Derived self, float y) {
  void Set(float y) { Base::x = y; }
};
template<typename T> struct M : L<T> {
  T w;
  T Get() { return 7; }
  // CHECK: return self.v + self.w + Get(
  void Change() {
    L<T>::v += 1;
    L<T>::Double();
  }
  T Sum() { return L<T>::v + w + L<T>::Get(); }
};
float4 main(float4 p : P) : SV_Target {
  A a;
  a.x = p.x;
  M<float> m;
  m.v = p.y;
  m.w = p.z;
  m.Change();
  Derived d;
  d.Set(p.w);
  // CHECK: q(a) + Sum(m)
  return a.q<7>() + m.Sum() + d.x;
}
