// A method is a function that takes its object first: `inout` where it may change it, `in` elsewhere.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
struct Base {
  float3 p;
  float length2() { return dot(p, p); }
  void scale(float by) { p *= by; }
};
struct Derived : Base {
  float4 q;
  static const float kHalf = 0.5;
  static float half_of(float x) { return x * kHalf; }
  float total() { return length2() + half_of(q.x); }
  float declared(float x);
  void twice() { this.q = q * 2; scale(2); }
};
float Derived::declared(float x) { return q.y + x; }
cbuffer C { Derived in_buffer; };
float3 of_base(Base base) { return base.p; }
float4 main(float4 position : POSITION) : SV_Position {
  Derived d = (Derived)0;
  d.twice();
  // CHECK: twice(d)
  // CHECK-NEXT: float a = (total(d) + declared(d, 1.0)) + half_of(2.0)
  float a = d.total() + d.declared(1) + Derived::half_of(2);
  // A method that may change its object, by its text, has a copy of one that cannot change.
  // CHECK: a += ((temporary = in_buffer), total(temporary)) + kHalf
  a += in_buffer.total() + Derived::kHalf;
  // CHECK-NEXT: a += of_base(Base{d.p}).x
  a += of_base(d).x;
  return position * a;
}
// CHECK: void twice(inout Derived self) {
// CHECK-NEXT: self.q = self.q * splat<float4>(2.0)
// CHECK-NEXT: scale(self, 2.0)
// CHECK: float total(inout Derived self.1) {
// CHECK-NEXT: return length2(self.1) + half_of(self.1.q.x)
// CHECK: float declared(Derived
// CHECK: float3 of_base(Base base)
// CHECK: void scale(inout Derived
