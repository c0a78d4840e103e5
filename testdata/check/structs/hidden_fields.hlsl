// A field that hides one of a base is another field: it lies after it, and has a name of its own in GLSL. Methods of the base, `Base::x`
// and `this.x` in them mean the base's field and the base's methods, as names are looked up in C++ ([class.member.lookup]).
// RUN: %clipc -T vs_5_0 %s --validate | FileCheck %s
// RUN: %clipc -T vs_5_0 -E methods %s --validate | FileCheck %s --check-prefix=METHODS
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,essl300,vulkan
// RUN: %draw compare %s -T vs_5_0 -E methods --target=glsl450,essl300,vulkan
struct Base { float4 x; };
// CHECK: struct Derived {
// CHECK-NEXT: vec4 x;
// CHECK-NEXT: vec4 x_2;
struct Derived : Base { float4 x; };
Derived given;
float4 main(float4 a : A) : SV_Position {
  Derived made;
  made.x = a;
  ((Base)made).x;
  // CHECK: gl_Position = made.x_2 + globals.given.x_2;
  return made.x + given.x;
}

class First { float other; };
class B {
  float v;
  void set(float x) { v = x; }
  void set_this(float x) { this.v = this.v + x; }
  float get() { return v; }
  float again() { return this.get(); }
};
class D : First, B {
  float v;
  float get() { return 100; }
  float both() { return v * 10 + B::v + B::get() * 1000; }
};
float OfBase(B b) { return b.v; }
// METHODS: void set(inout D self, float x) {
// METHODS-NEXT: self.v = x;
// METHODS: self.v = self.v + x;
// METHODS: return self.v;
// METHODS: self.v_2 * 10.0 + self.v
float4 methods(float a : A) : SV_Position {
  D d = (D)0;
  d.set(a);
  d.set_this(1);
  d.v = 7;
  d.B::set_this(2);
  d.B::v += 4;
  d.First::other = 5;
  return float4(d.get() + d.again(), d.both(), d.B::v + d.B::get(), OfBase(d) + ((B)d).v + d.other);
}
