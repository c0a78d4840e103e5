// RUN: %clipc --dump=ast %s | FileCheck %s
// AUTOUPDATE
namespace outer::inner {
struct Thing { float x; };
namespace { float hidden; }
}
namespace outer { inner::Thing thing; }
using namespace outer;
using outer::inner;
using Color = float4;
using Weights = float[4];

enum Plain { A, B = 2, C = A | B, };
enum class Scoped : uint { kOne = 1 };
enum Scoped scoped = Scoped::kOne;
enum { Unnamed } variable;

interface Shape { float area(float scale); };
class Base { float x; };
class Circle : Base, Shape {
  float r;
  static const int kCount = 3;
  static float shared_value;
  float area(float scale) { return r * scale; }
  float get() const { return r; }
  Circle operator+(Circle other) { return other; }
  float operator[](int i) { return r; }
  float operator()(float x) { return x; }
  bool operator==(Circle other);
  struct Nested { float n; };
  enum Kind { kSmall };
  public:
  float later;
};
float Circle::shared_value = 1;
float Circle::get() const { return 2; }
outer::inner::Thing outer::make() { outer::inner::Thing t; return t; }

template<typename T> struct Pair { T first; T second; static const int size = 2; };
template<typename T, uint N = 2> T sum(T values[N]) { return values[0]; }
template<> float sum<float, 3>(float values[3]) { return 0; }
template<> struct Pair<float> { float both; };
template<class T> T Pair<T>::get() { return first; }
Pair<float> pair;
Pair<Pair<float> > nested;
Pair<Pair<Pair<int>>> closer;
Pair<float>::Inner inner_type;
Sized<1 + 2, (3 > 2), A | B> sized;
void use() {
  x = Pair<int>::size + outer::inner::value;
  x = outer::call<float2>(x);
  y = sum<float, 2>(values);
  z = Circle::kCount;
  w = sizeof(float4) + sizeof(float[4]) + sizeof x;
  w = this.r + circle.get().later;
}
_Static_assert(sizeof(float) == 4, "float is four bytes");

// CHECK: namespace outer
// CHECK-NEXT:   namespace inner
// CHECK-NEXT:     struct Thing
// CHECK-NEXT:       field x : float
// CHECK-NEXT:     namespace <unnamed>
// CHECK-NEXT:       variable hidden : float
// CHECK-NEXT: namespace outer
// CHECK-NEXT:   variable thing : inner::Thing
// CHECK-NEXT: using namespace outer
// CHECK-NEXT: using outer::inner
// CHECK-NEXT: typedef Color : float4
// CHECK-NEXT: typedef Weights[4] : float
// CHECK-NEXT: enum Plain
// CHECK-NEXT:   value A
// CHECK-NEXT:   value B = 2
// CHECK-NEXT:   value C = (A | B)
// CHECK-NEXT: enum class Scoped : uint
// CHECK-NEXT:   value kOne = 1
// CHECK-NEXT: variable scoped : Scoped = Scoped::kOne
// CHECK-NEXT: variable variable : <unnamed>
// CHECK-NEXT:   enum <unnamed>
// CHECK-NEXT:     value Unnamed
// CHECK-NEXT: interface Shape
// CHECK-NEXT:   prototype area : float
// CHECK-NEXT:     parameter scale : float
// CHECK-NEXT: class Base
// CHECK-NEXT:   field x : float
// CHECK-NEXT: class Circle : Base, Shape
// CHECK-NEXT:   field r : float
// CHECK-NEXT:   field kCount : int static const = 3
// CHECK-NEXT:   field shared_value : float static
// CHECK-NEXT:   function area : float
// CHECK-NEXT:     parameter scale : float
// CHECK-NEXT:     block
// CHECK-NEXT:       return (r * scale)
// CHECK-NEXT:   function get : float const method
// CHECK-NEXT:     block
// CHECK-NEXT:       return r
// CHECK-NEXT:   function operator+ : Circle
// CHECK-NEXT:     parameter other : Circle
// CHECK-NEXT:     block
// CHECK-NEXT:       return other
// CHECK-NEXT:   function operator[] : float
// CHECK-NEXT:     parameter i : int
// CHECK-NEXT:     block
// CHECK-NEXT:       return r
// CHECK-NEXT:   function operator() : float
// CHECK-NEXT:     parameter x : float
// CHECK-NEXT:     block
// CHECK-NEXT:       return x
// CHECK-NEXT:   prototype operator== : bool
// CHECK-NEXT:     parameter other : Circle
// CHECK-NEXT:   struct Nested
// CHECK-NEXT:     field n : float
// CHECK-NEXT:   enum Kind
// CHECK-NEXT:     value kSmall
// CHECK-NEXT:   field later : float
// CHECK-NEXT: variable Circle::shared_value : float = 1
// CHECK-NEXT: function Circle::get : float const method
// CHECK-NEXT:   block
// CHECK-NEXT:     return 2
// CHECK-NEXT: function outer::make : outer::inner::Thing
// CHECK-NEXT:   block
// CHECK-NEXT:     variable t : outer::inner::Thing
// CHECK-NEXT:     return t
// CHECK-NEXT: struct Pair template
// CHECK-NEXT:   template parameter T : typename
// CHECK-NEXT:   field first : T
// CHECK-NEXT:   field second : T
// CHECK-NEXT:   field size : int static const = 2
// CHECK-NEXT: function sum : T template
// CHECK-NEXT:   template parameter T : typename
// CHECK-NEXT:   template parameter N : uint = 2
// CHECK-NEXT:   parameter values[N] : T
// CHECK-NEXT:   block
// CHECK-NEXT:     return values[0]
// CHECK-NEXT: function sum<float, 3> : float template
// CHECK-NEXT:   parameter values[3] : float
// CHECK-NEXT:   block
// CHECK-NEXT:     return 0
// CHECK-NEXT: struct Pair<float> template
// CHECK-NEXT:   field both : float
// CHECK-NEXT: function Pair::get<T> : T template
// CHECK-NEXT:   template parameter T : typename
// CHECK-NEXT:   block
// CHECK-NEXT:     return first
// CHECK-NEXT: variable pair : Pair<float>
// CHECK-NEXT: variable nested : Pair<Pair<float>>
// CHECK-NEXT: variable closer : Pair<Pair<Pair<int>>>
// CHECK-NEXT: variable inner_type : Pair<float>::Inner
// CHECK-NEXT: variable sized : Sized<(1 + 2), (3 > 2), (A | B)>
// CHECK-NEXT: function use : void
// CHECK-NEXT:   block
// CHECK-NEXT:     expression (x = (Pair<int>::size + outer::inner::value))
// CHECK-NEXT:     expression (x = outer::call<float2>(x))
// CHECK-NEXT:     expression (y = sum<float, 2>(values))
// CHECK-NEXT:     expression (z = Circle::kCount)
// CHECK-NEXT:     expression (w = ((sizeof(float4) + sizeof(float[4])) + sizeof(x)))
// CHECK-NEXT:     expression (w = (this.r + circle.get().later))
