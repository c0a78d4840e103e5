// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/functions.h"

#include <array>
#include <cstddef>
#include <iterator>

#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// HLSL reads the number of bits in a shift modulo 32, other languages leave more than 31 undefined.
Term Count(const Local& i) { return i & 31; }

Term ByteAt(const Local& word, const Local& i) { return (word >> Count(i)) & 255; }

// The byte of a word at bit 24 - i, as a number with a sign.
Term SignedByteAt(Formula& f, const Local& word, const Local& i) {
  return f.To(Scalar::kInt, word << Count(i)) >> 24;
}

// Packs four bytes into a word.
void ReturnPacked(Formula& f, const Term& bytes) {
  const Term counts = f.Vector(Scalar::kUint, {0, 8, 16, 24});
  const Local shifted = f.Let("bytes", bytes << counts);
  f.Return(shifted["x"] | shifted["y"] | shifted["z"] | shifted["w"]);
}

void ReturnBytes(Formula& f) {
  const Term counts = f.Vector(Scalar::kUint, {0, 8, 16, 24});
  f.Return((f.Splat(4, f[0]) >> counts) & 255);
}

void ReturnSignedBytes(Formula& f) {
  const Term counts = f.Vector(Scalar::kUint, {24, 16, 8, 0});
  f.Return(f.To(Scalar::kInt, f.Splat(4, f[0]) << counts) >> 24);
}

void Msad4(Formula& f) {
  const Local reference = f[0], source = f[1], sums = f[2];
  const Local windows = f.Let(
      "windows", f.Vector(Scalar::kUint, {source["x"], (source["x"] >> 8) | (source["y"] << 24),
                                          (source["x"] >> 16) | (source["y"] << 16),
                                          (source["x"] >> 24) | (source["y"] << 8)}));
  f.CountUp(32, 8, [&](const Local& i) {
    const Local wanted = f.Let("wanted", f.To(Scalar::kInt, ByteAt(reference, i)));
    f.If(wanted != 0, [&] {
      const Term distance = f.To(Scalar::kInt, ByteAt(windows, i)) - wanted;
      f.Change(BinaryOp::kAdd, sums, f.To(Scalar::kUint, f.Call(Intrinsic::kAbs, {distance})));
    });
  });
  f.Return(sums);
}

void Frexp(Formula& f) {
  const Local x = f[0], exponent = f[1];
  const Local bits = f.Let("bits", f.Bits(Scalar::kUint, x));
  const Term number = f.To(Scalar::kInt, (bits >> 23) & 255) - 126;
  const Scalar kind = x.Kind();
  f.Set(exponent, f.Choose(x == 0, 0, f.To(kind, number)));
  f.Return(f.Choose(x == 0, 0, f.Bits(kind, (bits & Mask{0x007FFFFF}) | Mask{0x3F000000})));
}

void Determinant4(Formula& f) {
  const Local m = f[0];
  const auto minor = [&](std::string_view name, int row, std::string_view left,
                         std::string_view right) {
    return f.Let(name, m[row][left] * m[row + 1][right] - m[row + 1][left] * m[row][right]);
  };
  const Local a = minor("a", 0, "x", "yz"), b = minor("b", 0, "x", "w");
  const Local c = minor("c", 0, "yy", "zw"), d = minor("d", 0, "z", "w");
  const Local e = minor("e", 2, "x", "yz"), g = minor("f", 2, "x", "w");
  const Local h = minor("g", 2, "yy", "zw"), i = minor("h", 2, "z", "w");
  f.Return(a["x"] * i - a["y"] * h["y"] + b * h["x"] + c["x"] * g - c["y"] * e["y"] + d * e["x"]);
}

void CountBits(Formula& f) {
  const Local x = f[0];
  f.Change(BinaryOp::kSub, x, (x >> 1) & Mask{0x55555555});
  f.Set(x, (x & Mask{0x33333333}) + ((x >> 2) & Mask{0x33333333}));
  f.Set(x, (x + (x >> 4)) & Mask{0x0F0F0F0F});
  f.Return((x * Mask{0x01010101}) >> 24);
}

void ReverseBits(Formula& f) {
  const Local x = f[0];
  const auto swap = [&](int count, Mask mask) {
    f.Set(x, ((x >> count) & mask) | ((x & mask) << count));
  };
  swap(1, {0x55555555});
  swap(2, {0x33333333});
  swap(4, {0x0F0F0F0F});
  swap(8, {0x00FF00FF});
  f.Return((x >> 16) | (x << 16));
}

// Returns the number of the bit that the function counts to and `is_wanted` holds of, or -1 as a
// uint.
void ReturnBit(Formula& f, const Local& i, const Term& is_wanted) {
  f.If(is_wanted, [&] { f.Return(f.To(Scalar::kUint, i)); });
}
Term NoBit(Formula& f) { return f.Number(Scalar::kUint, 4294967295.0, true); }

void FirstBitHigh(Formula& f) {
  f.CountDown(31, [&](const Local& i) { ReturnBit(f, i, ((f[0] >> Count(i)) & 1) != 0); });
  f.Return(NoBit(f));
}

void FirstBitHighOfInt(Formula& f) {
  const Local x = f[0];
  f.CountDown(30, [&](const Local& i) {
    const Term sign = f.Choose(x < 0, f.Number(Scalar::kInt, 1), 0);
    ReturnBit(f, i, ((x >> Count(i)) & 1) != sign);
  });
  f.Return(NoBit(f));
}

void FirstBitLow(Formula& f) {
  f.CountUp(32, 1, [&](const Local& i) { ReturnBit(f, i, ((f[0] >> Count(i)) & 1) != 0); });
  f.Return(NoBit(f));
}

void F16ToF32(Formula& f) {
  const Local x = f[0];
  const Local sign_bit = f.Let("sign_bit", (x & Mask{0x8000}) << 16);
  const Local exponent = f.Let("exponent", (x >> 10) & 31);
  const Local mantissa = f.Let("mantissa", x & 1023);
  const auto number = [&](const Term& bits) { return f.Bits(Scalar::kFloat, sign_bit | bits); };
  f.If(exponent == 0, [&] {
    const Term scale = f.Call(Intrinsic::kExp2, {f.Number(Scalar::kFloat, -24)});
    f.Return(number(f.Bits(Scalar::kUint, f.To(Scalar::kFloat, mantissa) * scale)));
  });
  f.If(exponent == 31,
       [&] { f.Return(f.Bits(Scalar::kFloat, sign_bit | Mask{0x7F800000} | (mantissa << 13))); });
  f.Return(f.Bits(Scalar::kFloat, sign_bit | ((exponent + 112) << 23) | (mantissa << 13)));
}

void F32ToF16(Formula& f) {
  const Local x = f[0];
  const Local bits = f.Let("bits", f.Bits(Scalar::kUint, x));
  const Local sign_bit = f.Let("sign_bit", (bits >> 16) & Mask{0x8000});
  f.Change(BinaryOp::kBitAnd, bits, Mask{0x7FFFFFFF});
  f.If(bits > Mask{0x7F800000}, [&] { f.Return(sign_bit | Mask{0x7E00}); });
  f.If(bits >= Mask{0x477FF000}, [&] { f.Return(sign_bit | Mask{0x7C00}); });
  f.If(bits < Mask{0x38800000}, [&] {
    const Term whole = f.Call(Intrinsic::kRound, {f.Call(Intrinsic::kAbs, {x}) * 16777216});
    f.Return(sign_bit | f.To(Scalar::kUint, whole));
  });
  const Term rounded = bits - Mask{0x38000000} + Mask{0x0FFF} + ((bits >> 13) & 1);
  f.Return(sign_bit | (rounded >> 13));
}

// Calls the function and keeps its number in a variable, which has 32 bits.
void InVariable(Formula& f, Intrinsic op, std::string_view name) {
  const Local number = f.Let(name, f.To(Scalar::kInt, f.Call(op, {f[0]})));
  f.Return(f.To(Scalar::kUint, number));
}

Term OfQuad(Formula& f, Intrinsic op) {
  const Local x = f[0];
  const auto across = [&](Intrinsic to) { return f.Call(to, {x}); };
  return f.Call(op, {f.Vector(Scalar::kBool, {x, across(Intrinsic::kQuadReadAcrossX),
                                              across(Intrinsic::kQuadReadAcrossY),
                                              across(Intrinsic::kQuadReadAcrossDiagonal)})});
}

using enum Intrinsic;
using F = Function;

// The rows of one function are neighbours.
constexpr Function kFunctions[] = {
    // ---- HLSL's own meaning
    {kSaturate, nullptr, F::kFloats, false, "x",
     [](Formula& f) {
       f.Return(f.Call(kMin, {f.Call(kMax, {0, f[0]}), 1}));
       f.Remark("0 for NaN");
     }},
    {kSmoothstep, nullptr, F::kFloats, false, "a b x",
     [](Formula& f) {
       const Local a = f[0], b = f[1], x = f[2];
       const Local t = f.Let("t", f.Call(kSaturate, {(x - a) / (b - a)}));
       f.Return(t * t * (t * -2 + 3));
     }},
    {kIsFinite, nullptr, F::kFloats, true, "x",
     [](Formula& f) { f.Return(!(f.Call(kIsNan, {f[0]}) || f.Call(kIsInf, {f[0]}))); }},
    {kLit, nullptr, F::kFloats, true, "n_dot_l n_dot_h m",
     [](Formula& f) {
       const Local l = f[0], h = f[1], m = f[2];
       const Local specular = f.Let("specular", f.Choose(l < 0 || h < 0, 0, f.Call(kPow, {h, m})));
       f.Return(f.Vector(l.Kind(), {1, f.Call(kMax, {l, 0}), specular, 1}));
     }},
    {kMsad4, nullptr, F::kUints, true, "reference source sums", Msad4},
    {kQuadAll, nullptr, F::kAll, true, "x", [](Formula& f) { f.Return(OfQuad(f, kAll)); }},
    {kQuadAny, nullptr, F::kAll, true, "x", [](Formula& f) { f.Return(OfQuad(f, kAny)); }},
    {kDot2Add, nullptr, F::kFloats, false, "a b sum",
     [](Formula& f) { f.Return(f.Call(kDot, {f[0], f[1]}) + f[2]); }},
    {kDot4AddU8, nullptr, F::kUints, false, "a b sum",
     [](Formula& f) {
       f.CountUp(32, 8, [&](const Local& i) {
         f.Change(BinaryOp::kAdd, f[2], ByteAt(f[0], i) * ByteAt(f[1], i));
       });
       f.Return(f[2]);
     }},
    {kDot4AddI8, nullptr, F::kUints, false, "a b sum",
     [](Formula& f) {
       f.CountUp(32, 8, [&](const Local& i) {
         f.Change(BinaryOp::kAdd, f[2], SignedByteAt(f, f[0], i) * SignedByteAt(f, f[1], i));
       });
       f.Return(f[2]);
     }},
    {kPackU8, nullptr, F::kUints, false, "x", [](Formula& f) { ReturnPacked(f, f[0] & 255); }},
    {kPackS8, nullptr, F::kInts, false, "x",
     [](Formula& f) { ReturnPacked(f, f.To(Scalar::kUint, f[0]) & 255); }},
    {kPackClampU8, nullptr, F::kInts, false, "x",
     [](Formula& f) { ReturnPacked(f, f.To(Scalar::kUint, f.Call(kClamp, {f[0], 0, 255}))); }},
    {kPackClampS8, nullptr, F::kInts, false, "x",
     [](Formula& f) {
       ReturnPacked(f, f.To(Scalar::kUint, f.Call(kClamp, {f[0], -128, 127})) & 255);
     }},
    {kUnpackU8U32, nullptr, F::kUints, false, "x", ReturnBytes},
    {kUnpackU8U16, nullptr, F::kUints, false, "x", ReturnBytes},
    {kUnpackS8S32, nullptr, F::kUints, false, "x", ReturnSignedBytes},
    {kUnpackS8S16, nullptr, F::kUints, false, "x", ReturnSignedBytes},
    {kDst, nullptr, F::kFloats, false, "a b",
     [](Formula& f) {
       const Local a = f[0], b = f[1];
       f.Return(f.Vector(a.Kind(), {1, a["y"] * b["y"], a["z"], b["w"]}));
     }},
    {kFrexp, nullptr, F::kFloats, true, "x exponent", Frexp},

    // ---- before GLSL 1.30
    {kTrunc, &Needs::rounding, F::kFloats, false, "x",
     [](Formula& f) { f.Return(f.Sign(f[0]) * f.Call(kFloor, {f.Call(kAbs, {f[0]})})); }},
    {kRound, &Needs::rounding, F::kFloats, true, "x",
     [](Formula& f) {
       const Local below = f.Let("below", f.Call(kFloor, {f[0]}));
       const Local rest = f.Let("rest", f[0] - below);
       const Term is_even = f.Call(kFrac, {below * 0.5}) == 0;
       f.Return(f.Choose(rest < 0.5 || (rest == 0.5 && is_even), below, below + 1));
     }},
    {kIsNan, &Needs::rounding, F::kFloats, true, "x", [](Formula& f) { f.Return(f[0] != f[0]); }},
    {kIsInf, &Needs::rounding, F::kFloats, true, "x",
     [](Formula& f) { f.Return(f[0] != 0 && f[0] + f[0] == f[0]); }},
    {kSinh, &Needs::rounding, F::kFloats, false, "x",
     [](Formula& f) { f.Return(0.5 * (f.Call(kExp, {f[0]}) - f.Call(kExp, {-f[0]}))); }},
    {kCosh, &Needs::rounding, F::kFloats, false, "x",
     [](Formula& f) { f.Return(0.5 * (f.Call(kExp, {f[0]}) + f.Call(kExp, {-f[0]}))); }},
    {kTanh, &Needs::rounding, F::kFloats, false, "x",
     [](Formula& f) {
       const Local e = f.Let("e", f.Call(kExp, {-2 * f.Call(kAbs, {f[0]})}));
       f.Return(f.Sign(f[0]) * (1 - e) / (1 + e));
     }},
    {kAbs, &Needs::signed_integers, F::kInts, true, "x",
     [](Formula& f) { f.Return(f.Choose(f[0] < 0, -f[0], f[0])); }},
    {kSign, &Needs::signed_integers, F::kInts, true, "x",
     [](Formula& f) {
       const Local x = f[0];
       const Term zero = f.Number(Scalar::kInt, 0);
       f.Return(f.Choose(x > 0, 1, f.Choose(x < 0, -1, zero)));
     }},
    {kMin, &Needs::signed_integers, F::kIntegers, true, "x y",
     [](Formula& f) { f.Return(f.Choose(f[1] < f[0], f[1], f[0])); }},
    {kMax, &Needs::signed_integers, F::kIntegers, true, "x y",
     [](Formula& f) { f.Return(f.Choose(f[0] < f[1], f[1], f[0])); }},
    {kClamp, &Needs::signed_integers, F::kIntegers, true, "x low high",
     [](Formula& f) {
       const Local y = f.Let("y", f.Choose(f[0] < f[1], f[1], f[0]));
       f.Return(f.Choose(f[2] < y, f[2], y));
     }},

    // ---- before GLSL 1.50
    {kDeterminant, &Needs::determinants, F::kRows2, false, "m",
     [](Formula& f) {
       const Local m = f[0];
       f.Return(m[0]["x"] * m[1]["y"] - m[0]["y"] * m[1]["x"]);
     },
     "determinant2"},
    {kDeterminant, &Needs::determinants, F::kRows3, false, "m",
     [](Formula& f) {
       const Local m = f[0];
       f.Return(f.Call(kDot, {m[0], f.Call(kCross, {m[1], m[2]})}));
     },
     "determinant3"},
    {kDeterminant, &Needs::determinants, F::kRows4, false, "m", Determinant4, "determinant4"},

    // ---- before GLSL 4.00 and GLSL ES 3.10
    {kCountBits, &Needs::bit_functions, F::kUints, false, "x", CountBits},
    {kCountBits, &Needs::wide_bit_numbers, F::kUints, false, "x",
     [](Formula& f) { InVariable(f, kCountBits, "count"); }, "count_bits"},
    {kReverseBits, &Needs::bit_functions, F::kUints, false, "x", ReverseBits},
    {kFirstBitHigh, &Needs::bit_functions, F::kUints, true, "x", FirstBitHigh},
    {kFirstBitHigh, &Needs::bit_functions, F::kInts, true, "x", FirstBitHighOfInt},
    {kFirstBitHigh, &Needs::wide_bit_numbers, F::kIntegers, false, "x",
     [](Formula& f) { InVariable(f, kFirstBitHigh, "bit"); }, "first_bit_high"},
    {kFirstBitLow, &Needs::bit_functions, F::kUints, true, "x", FirstBitLow},
    {kFirstBitLow, &Needs::wide_bit_numbers, F::kUints, false, "x",
     [](Formula& f) { InVariable(f, kFirstBitLow, "bit"); }, "first_bit_low"},

    // ---- before GLSL 4.20
    {kF16ToF32, &Needs::half_packing, F::kUints, true, "x", F16ToF32},
    {kF32ToF16, &Needs::half_packing, F::kFloats, true, "x", F32ToF16},
};

// The first row of each function, counted from 1; 0 for one that every target has.
constexpr auto kFirstRow = [] {
  std::array<std::uint8_t, 256> rows{};
  for (std::size_t i = std::size(kFunctions); i-- > 0;)
    rows[static_cast<std::size_t>(kFunctions[i].op)] = static_cast<std::uint8_t>(i + 1);
  return rows;
}();

bool Takes(const Function& function, const Type& type) {
  const bool is_square = type.kind == TypeKind::kMatrix && type.rows == type.columns;
  switch (function.of) {
    case F::kAll: return true;
    case F::kFloats: return IsFloat(type.scalar);
    case F::kIntegers: return IsInteger(type.scalar);
    case F::kInts: return IsInteger(type.scalar) && !IsUnsigned(type.scalar);
    case F::kUints: return IsInteger(type.scalar) && IsUnsigned(type.scalar);
    case F::kRows2: return is_square && type.rows == 2;
    case F::kRows3: return is_square && type.rows == 3;
    case F::kRows4: return is_square && type.rows == 4;
  }
  return false;
}

}  // namespace

const Function* FindFunction(Intrinsic op, const Type& first, const Needs& needs) {
  const std::uint8_t row = kFirstRow[static_cast<std::size_t>(op)];
  if (row == 0) return nullptr;
  for (const Function* function = &kFunctions[row - 1];
       function != std::end(kFunctions) && function->op == op; ++function) {
    if ((!function->need || needs.*function->need) && Takes(*function, first)) return function;
  }
  return nullptr;
}

bool IsOfScalars(Intrinsic op, const Type& first, const Needs& needs) {
  if (CategoryOf(op) == IntrinsicCategory::kVectors) return false;
  const Function* function = FindFunction(op, first, needs);
  const bool takes_scalars = op == kWaveActiveAllEqual || op == kAsDouble || op == kF16ToF32 ||
                             op == kF32ToF16 || (function && function->of_scalars);
  return takes_scalars && ShapeOf(first, needs).IsVector();
}

}  // namespace clipc::legalize
