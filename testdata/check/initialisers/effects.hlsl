// A static variable that nothing names gets its value where that has an effect, whatever has it: the definition of a member, an
// operator, a default argument, a template.
// RUN: %clipc -T vs_6_0 -HV 2021 --validate %s -o - | FileCheck %s
static int count;
int Next() { return ++count; }
struct Counted { static int member; float x; };
int Counted::member = Next();
static Counted counted;

struct Number {
  int value;
  Number operator+(Number other) {
    ++count;
    Number sum;
    sum.value = value + other.value;
    return sum;
  }
};
static Number one = { 1 };
static Number two = one + one;

int Given(int x = Next()) { return x; }
static int given = Given();

template <typename T> T Add(T x) { count += x; return x; }
static int added = Add<int>(2);

namespace space { static int inside = Next(); }

// CHECK: void main() {
// CHECK-NEXT: member = Next();
// CHECK-NEXT: two = operator_(one, one);
// CHECK-NEXT: given = Given(Next());
// CHECK-NEXT: added = Add(2);
// CHECK-NEXT: inside = Next();
// CHECK-NEXT: gl_Position
float4 main(float4 p : P) : SV_Position { return p + count + counted.x; }
