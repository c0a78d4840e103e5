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
