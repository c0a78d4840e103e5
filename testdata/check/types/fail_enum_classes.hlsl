// Between an enum class and numbers, or another enum, there are casts only, as in C++ and dxc ("cannot initialize a variable of type
// 'int' with an rvalue of type 'Mode'"); and it has no arithmetic.
// RUN: not %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s
enum class Mode { Lit, Flat };
enum class Side { Left, Right };
struct Settings {
  Mode mode;
};
int Number(int x) { return x; }
// CHECK-DAG: [[#@LINE+1]]:26: error: `int` and `Mode` are mixed; from and to an enum class there are casts only, `int(x)` [enum-class-conversion]
Mode Returned() { return 1; }
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK-DAG: [[#@LINE+1]]:11: error: `Mode` and `int` are mixed
  int a = Mode::Flat;
  // CHECK-DAG: [[#@LINE+1]]:15: error: `int` and `Mode` are mixed
  Mode mode = 1;
  // CHECK-DAG: [[#@LINE+1]]:15: error: `Mode` and `Side` are mixed
  Side side = mode;
  // CHECK-DAG: [[#@LINE+1]]:20: error: `Mode` and `int` are mixed
  float b = Number(mode);
  Settings s;
  // CHECK-DAG: [[#@LINE+1]]:12: error: `int` and `Mode` are mixed
  s.mode = 0;
  // CHECK-DAG: [[#@LINE+1]]:12: error: `Mode` and `Side` are mixed
  if (mode == Side::Left) a = 1;
  // CHECK-DAG: [[#@LINE+1]]:14: error: operator `+` is applied to a `Mode`; it needs numbers [bad-operand, X3022]
  a += (mode + 1);
  // CHECK-DAG: [[#@LINE+1]]:3: error: operator `++` is applied to a `Mode`
  mode++;
  // CHECK-DAG: [[#@LINE+1]]:12: error: operator `*` is applied to a `Mode`
  return p * Mode::Flat * (int)Returned();
}
