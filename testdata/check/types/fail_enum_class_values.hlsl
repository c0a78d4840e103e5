// Between the braces an enumerator of an enum class has the underlying type (C++ 7.2, dcl.enum), and operators take it; after them
// only a cast makes a number of it.
// RUN: not %clipc -T vs_6_0 -DAFTER -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=AFTER
// RUN: %clipc -T vs_6_0 %s -o - | FileCheck %s
enum class E : uint { A = 3, B = A + 2, C = A << 2, D = (B | C) & ~E::A, F = -1 * A, G };
enum class Other { A = (int)E::B, B = A * 2 };
// CHECK: gl_Position = in_P0 * 5.0 + 12.0 + 12.0 + 10.0;
float4 main(float4 p : P) : SV_Position {
#ifdef AFTER
  // AFTER: error: operator `+` is applied to a `E`; it needs numbers [bad-operand, X3022]
  uint n = (uint)(E::A + 2);
#endif
  return p * (uint)E::B + (uint)E::C + (uint)E::D + (int)Other::B;
}
