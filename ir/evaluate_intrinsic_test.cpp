// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ir/builder.h"
#include "ir/evaluate.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"
#include "ir/test_program.h"
#include "ir/verifier.h"

// Every expected number here was computed by hand or follows from the document that the comment
// names.
namespace clipc::ir {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

// Builds an expression of literals and evaluates it.
class Intrinsics : public testing::Test {
 protected:
  using Numbers = std::vector<double>;

  ExprId Value(Scalar kind, const Numbers& components) {
    if (components.size() == 1) return build.LiteralOf(kind, components[0]);
    return Made(program.types.Vector(kind, static_cast<int>(components.size())), components);
  }
  ExprId Made(TypeId type, const Numbers& components) {
    std::vector<ExprId> parts;
    for (double component : components)
      parts.push_back(build.LiteralOf(program.types[type].scalar, component));
    return build.ConstructOf(type, parts);
  }
  ExprId Matrix(int rows, int columns, const Numbers& components) {
    return Made(program.types.Matrix(Scalar::kFloat, rows, columns), components);
  }
  TypeId FloatType(int columns) {
    return columns == 1 ? program.types.Make(Scalar::kFloat)
                        : program.types.Vector(Scalar::kFloat, columns);
  }

  std::vector<std::uint64_t> Bits(ExprId expr) { return ValueOf(program, expr); }
  Numbers Evaluated(ExprId expr) {
    Numbers numbers;
    for (std::uint64_t bits : Bits(expr))
      numbers.push_back(NumberOf(bits, program.types[build.TypeOf(expr)].scalar));
    return numbers;
  }
  ExprId Call(Intrinsic op, TypeId type, std::initializer_list<ExprId> arguments) {
    const ExprId call = build.IntrinsicOf(op, type, arguments);
    std::vector<TypeId> types;
    for (ExprId argument : arguments) types.push_back(build.TypeOf(argument));
    EXPECT_EQ(CheckIntrinsic(program.types, op, type, types), std::nullopt);
    return call;
  }
  // A component-wise function of float scalars with a float result.
  double F(Intrinsic op, double x) {
    return Evaluated(Call(op, FloatType(1), {build.Float(static_cast<float>(x))}))[0];
  }
  double F(Intrinsic op, double x, double y) {
    return Evaluated(
        Call(op, FloatType(1), {Value(Scalar::kFloat, {x}), Value(Scalar::kFloat, {y})}))[0];
  }
  double F(Intrinsic op, double x, double y, double z) {
    return Evaluated(Call(
        op, FloatType(1),
        {Value(Scalar::kFloat, {x}), Value(Scalar::kFloat, {y}), Value(Scalar::kFloat, {z})}))[0];
  }
  double Of(Intrinsic op, Scalar result, Scalar kind, const Numbers& arguments) {
    std::vector<ExprId> values;
    for (double argument : arguments) values.push_back(Value(kind, {argument}));
    const TypeId type = program.types.Make(result);
    if (values.size() == 1) return Evaluated(Call(op, type, {values[0]}))[0];
    if (values.size() == 2) return Evaluated(Call(op, type, {values[0], values[1]}))[0];
    return Evaluated(Call(op, type, {values[0], values[1], values[2]}))[0];
  }

  Program program;
  Builder build{program};
};

// Window 0 is 0x40302010 and differs by 0x0f, 0x1e, 0x2d and 0x3c from the bytes 1, 2, 3, 4. The
// reference's byte 0 masks the third byte of the second call.
TEST_F(Intrinsics, Msad4) {
  const TypeId uint4 = program.types.Vector(Scalar::kUint, 4);
  const auto msad4 = [&](std::uint32_t reference) {
    return Bits(Call(Intrinsic::kMsad4, uint4,
                     {build.Uint(reference), Value(Scalar::kUint, {0x40302010, 0x80706050}),
                      Value(Scalar::kUint, {0, 1, 2, 0xffffffff})}));
  };
  EXPECT_THAT(msad4(0x04030201), ElementsAre(150, 215, 280, 341));
  EXPECT_THAT(msad4(0x04000201), ElementsAre(105, 154, 203, 248));
}

TEST_F(Intrinsics, RoundGoesToEvenOnTies) {
  EXPECT_EQ(F(Intrinsic::kRound, 0.5), 0);
  EXPECT_EQ(F(Intrinsic::kRound, 1.5), 2);
  EXPECT_EQ(F(Intrinsic::kRound, 2.5), 2);
  EXPECT_EQ(F(Intrinsic::kRound, -2.5), -2);
  EXPECT_EQ(F(Intrinsic::kRound, 2.6), 3);
}

TEST_F(Intrinsics, OtherRoundings) {
  EXPECT_EQ(F(Intrinsic::kFloor, -1.5), -2);
  EXPECT_EQ(F(Intrinsic::kCeil, -1.5), -1);
  EXPECT_EQ(F(Intrinsic::kTrunc, -1.5), -1);
  EXPECT_EQ(F(Intrinsic::kFrac, -1.25), 0.75);
}

TEST_F(Intrinsics, SaturateOfNanIsZero) {
  EXPECT_EQ(F(Intrinsic::kSaturate, kNan), 0);
  EXPECT_EQ(F(Intrinsic::kSaturate, kInf), 1);
  EXPECT_EQ(F(Intrinsic::kSaturate, -3), 0);
  EXPECT_EQ(F(Intrinsic::kSaturate, 0.25), 0.25);
}

TEST_F(Intrinsics, MinAndMaxPreferTheNumber) {
  EXPECT_EQ(F(Intrinsic::kMin, kNan, 2), 2);
  EXPECT_EQ(F(Intrinsic::kMin, 2, kNan), 2);
  EXPECT_EQ(F(Intrinsic::kMax, kNan, -2), -2);
  EXPECT_TRUE(std::isnan(F(Intrinsic::kMax, kNan, kNan)));
  EXPECT_EQ(F(Intrinsic::kClamp, kNan, -1, 1), -1);
  EXPECT_EQ(F(Intrinsic::kClamp, 5, -1, 1), 1);
  EXPECT_EQ(Of(Intrinsic::kMin, Scalar::kInt, Scalar::kInt, {-1, 1}), -1);
  EXPECT_EQ(Of(Intrinsic::kMin, Scalar::kUint, Scalar::kUint, {4294967295.0, 1}), 1);
  EXPECT_EQ(Of(Intrinsic::kClamp, Scalar::kInt, Scalar::kInt, {-7, -3, 3}), -3);
}

TEST_F(Intrinsics, FmodIsTruncated) {
  EXPECT_EQ(F(Intrinsic::kFmod, 5.5, 2), 1.5);
  EXPECT_EQ(F(Intrinsic::kFmod, -5.5, 2), -1.5);
  EXPECT_EQ(F(Intrinsic::kFmod, 5.5, -2), 1.5);
  EXPECT_TRUE(std::isnan(F(Intrinsic::kFmod, 1, 0)));
}

TEST_F(Intrinsics, PowOfNegativeAndZeroBases) {
  EXPECT_EQ(F(Intrinsic::kPow, 2, 10), 1024);
  EXPECT_TRUE(std::isnan(F(Intrinsic::kPow, -2, 2)));
  EXPECT_TRUE(std::isnan(F(Intrinsic::kPow, 0, 0)));
  EXPECT_EQ(F(Intrinsic::kPow, 0, 3), 0);
  EXPECT_EQ(F(Intrinsic::kPow, 0, -1), kInf);
  EXPECT_EQ(F(Intrinsic::kPow, 7, 0), 1);
}

TEST_F(Intrinsics, Transcendental) {
  EXPECT_EQ(F(Intrinsic::kSin, 0), 0);
  EXPECT_EQ(F(Intrinsic::kCos, 0), 1);
  EXPECT_EQ(F(Intrinsic::kTan, 0), 0);
  EXPECT_EQ(F(Intrinsic::kExp2, 3), 8);
  EXPECT_EQ(F(Intrinsic::kLog2, 8), 3);
  EXPECT_EQ(F(Intrinsic::kLog10, 1000), 3);
  EXPECT_EQ(F(Intrinsic::kLog, 1), 0);
  EXPECT_EQ(F(Intrinsic::kLog2, 0), -kInf);
  EXPECT_TRUE(std::isnan(F(Intrinsic::kLog2, -1)));
  EXPECT_NEAR(F(Intrinsic::kExp, 1), 2.718281828, 2e-7);
  EXPECT_EQ(F(Intrinsic::kSqrt, 9), 3);
  EXPECT_TRUE(std::isnan(F(Intrinsic::kSqrt, -1)));
  EXPECT_EQ(F(Intrinsic::kRsqrt, 4), 0.5);
  EXPECT_EQ(F(Intrinsic::kRsqrt, 0), kInf);
  EXPECT_EQ(F(Intrinsic::kRcp, 4), 0.25);
  EXPECT_NEAR(F(Intrinsic::kAcos, -1), 3.14159265, 2e-7);
  EXPECT_TRUE(std::isnan(F(Intrinsic::kAsin, 2)));
  EXPECT_NEAR(F(Intrinsic::kAtan, 1), 0.785398163, 1e-7);
  EXPECT_NEAR(F(Intrinsic::kAtan2, 1, -1), 2.35619449, 2e-7);
  EXPECT_EQ(F(Intrinsic::kSinh, 0), 0);
  EXPECT_EQ(F(Intrinsic::kCosh, 0), 1);
  EXPECT_EQ(F(Intrinsic::kTanh, kInf), 1);
  EXPECT_NEAR(F(Intrinsic::kDegrees, 3.14159265), 180, 2e-5);
  EXPECT_NEAR(F(Intrinsic::kRadians, 180), 3.14159265, 3e-7);
}

TEST_F(Intrinsics, ArithmeticOfThree) {
  EXPECT_EQ(F(Intrinsic::kLerp, 2, 6, 0.25), 3);
  EXPECT_EQ(F(Intrinsic::kMad, 2, 3, 4), 10);
  EXPECT_EQ(F(Intrinsic::kStep, 1, 1), 1);
  EXPECT_EQ(F(Intrinsic::kStep, 1, 0.5), 0);
  EXPECT_EQ(F(Intrinsic::kStep, 1, kNan), 0);
  EXPECT_EQ(F(Intrinsic::kSmoothstep, 0, 4, 1), 0.15625);
  EXPECT_EQ(F(Intrinsic::kSmoothstep, 0, 4, 9), 1);
  EXPECT_EQ(F(Intrinsic::kLdexp, 3, -2), 0.75);
  EXPECT_EQ(Of(Intrinsic::kMad, Scalar::kUint, Scalar::kUint, {2147483648.0, 2, 5}), 5);
  EXPECT_EQ(Of(Intrinsic::kFma, Scalar::kDouble, Scalar::kDouble, {0.1, 10, -1}),
            std::fma(0.1, 10.0, -1.0));
}

// mad rounds the product: 4097 * 4097 = 2^24 + 2^13 + 1 does not fit a float.
TEST_F(Intrinsics, MadIsNotFused) { EXPECT_EQ(F(Intrinsic::kMad, 4097, 4097, -16785408), 0); }

TEST_F(Intrinsics, SignIsAnInteger) {
  EXPECT_EQ(Of(Intrinsic::kSign, Scalar::kInt, Scalar::kFloat, {-0.5}), -1);
  EXPECT_EQ(Of(Intrinsic::kSign, Scalar::kInt, Scalar::kFloat, {0}), 0);
  EXPECT_EQ(Of(Intrinsic::kSign, Scalar::kInt, Scalar::kFloat, {kNan}), 0);
  EXPECT_EQ(Of(Intrinsic::kSign, Scalar::kInt, Scalar::kInt, {7}), 1);
  EXPECT_EQ(Of(Intrinsic::kAbs, Scalar::kInt, Scalar::kInt, {-7}), 7);
  EXPECT_EQ(Of(Intrinsic::kAbs, Scalar::kInt, Scalar::kInt, {-2147483648.0}), -2147483648.0);
  EXPECT_EQ(F(Intrinsic::kAbs, -0.0), 0);
}

TEST_F(Intrinsics, Classification) {
  EXPECT_EQ(Of(Intrinsic::kIsNan, Scalar::kBool, Scalar::kFloat, {kNan}), 1);
  EXPECT_EQ(Of(Intrinsic::kIsInf, Scalar::kBool, Scalar::kFloat, {-kInf}), 1);
  EXPECT_EQ(Of(Intrinsic::kIsFinite, Scalar::kBool, Scalar::kFloat, {kInf}), 0);
  EXPECT_EQ(Of(Intrinsic::kIsFinite, Scalar::kBool, Scalar::kFloat, {1}), 1);
}

TEST_F(Intrinsics, BitCounting) {
  const auto u = [&](Intrinsic op, double x) { return Of(op, Scalar::kUint, Scalar::kUint, {x}); };
  EXPECT_EQ(u(Intrinsic::kCountBits, 0xF0F0), 8);
  EXPECT_EQ(u(Intrinsic::kFirstBitHigh, 1), 0);
  EXPECT_EQ(u(Intrinsic::kFirstBitHigh, 0x80000000u), 31);
  EXPECT_EQ(u(Intrinsic::kFirstBitHigh, 0), 4294967295.0);
  EXPECT_EQ(u(Intrinsic::kFirstBitLow, 0x50), 4);
  EXPECT_EQ(u(Intrinsic::kFirstBitLow, 0), 4294967295.0);
  EXPECT_EQ(u(Intrinsic::kReverseBits, 3), 0xC0000000u);
  // A signed number gives the first bit that differs from the sign.
  EXPECT_EQ(Of(Intrinsic::kFirstBitHigh, Scalar::kUint, Scalar::kInt, {-2}), 0);
  EXPECT_EQ(Of(Intrinsic::kFirstBitHigh, Scalar::kUint, Scalar::kInt, {-1}), 4294967295.0);
  EXPECT_EQ(Of(Intrinsic::kFirstBitHigh, Scalar::kUint, Scalar::kInt, {-129}), 7);
}

TEST_F(Intrinsics, BitCastsKeepEveryBit) {
  const TypeId uint_type = program.types.Make(Scalar::kUint);
  const ExprId nan = build.Add(FloatType(1), Literal{0x7fa00001u});
  EXPECT_EQ(Bits(Call(Intrinsic::kAsUint, uint_type, {nan}))[0], 0x7fa00001u);
  EXPECT_EQ(Bits(Call(Intrinsic::kAsFloat, FloatType(1), {build.Uint(0xffc12345u)}))[0],
            0xffc12345u);
  EXPECT_EQ(Of(Intrinsic::kAsInt, Scalar::kInt, Scalar::kFloat, {-0.0}), -2147483648.0);
  EXPECT_EQ(Of(Intrinsic::kAsFloat, Scalar::kFloat, Scalar::kUint, {0x40490fdbu}),
            3.14159274101257324);
  EXPECT_EQ(Of(Intrinsic::kAsDouble, Scalar::kDouble, Scalar::kUint, {0, 0x3ff80000u}), 1.5);
}

TEST_F(Intrinsics, HalfConversions) {
  const auto to_half = [&](double x) {
    return Of(Intrinsic::kF32ToF16, Scalar::kUint, Scalar::kFloat, {x});
  };
  const auto from_half = [&](double x) {
    return Of(Intrinsic::kF16ToF32, Scalar::kFloat, Scalar::kUint, {x});
  };
  EXPECT_EQ(to_half(1), 0x3c00);
  EXPECT_EQ(to_half(-2), 0xc000);
  EXPECT_EQ(to_half(65504), 0x7bff);
  EXPECT_EQ(to_half(65536), 0x7c00);
  EXPECT_EQ(to_half(0x1p-24), 1);
  EXPECT_EQ(to_half(0x1p-14), 0x0400);
  EXPECT_EQ(to_half(0), 0);
  EXPECT_EQ(from_half(0x3c00), 1);
  EXPECT_EQ(from_half(0xffff3c00u), 1);
  EXPECT_EQ(from_half(0x0001), 0x1p-24);
  EXPECT_EQ(from_half(0xfc00), -kInf);
  EXPECT_TRUE(std::isnan(from_half(0x7e00)));
}

TEST_F(Intrinsics, AllAndAny) {
  const TypeId boolean = program.types.Make(Scalar::kBool);
  EXPECT_EQ(Evaluated(Call(Intrinsic::kAll, boolean, {Value(Scalar::kFloat, {1, -2, kNan})}))[0],
            1);
  EXPECT_EQ(Evaluated(Call(Intrinsic::kAll, boolean, {Value(Scalar::kFloat, {1, -0.0, 1})}))[0], 0);
  EXPECT_EQ(Evaluated(Call(Intrinsic::kAny, boolean, {Value(Scalar::kInt, {0, 0})}))[0], 0);
  EXPECT_EQ(Evaluated(Call(Intrinsic::kAny, boolean, {Value(Scalar::kBool, {0, 1})}))[0], 1);
}

TEST_F(Intrinsics, Products) {
  const ExprId a = Value(Scalar::kFloat, {1, 2, 3});
  const ExprId b = Value(Scalar::kFloat, {4, 5, 6});
  EXPECT_THAT(Evaluated(Call(Intrinsic::kDot, FloatType(1), {a, b})), ElementsAre(32));
  EXPECT_THAT(Evaluated(Call(Intrinsic::kCross, FloatType(3), {a, b})), ElementsAre(-3, 6, -3));
  EXPECT_EQ(Evaluated(Call(Intrinsic::kDot, program.types.Make(Scalar::kInt),
                           {Value(Scalar::kInt, {1, -2}), Value(Scalar::kInt, {3, 4})}))[0],
            -5);
}

// The sum is made from left to right: (1e8 + 1) - 1e8 loses the 1; the other order would keep it.
TEST_F(Intrinsics, DotAddsFromLeftToRight) {
  const ExprId a = Value(Scalar::kFloat, {1e8, 1, -1e8});
  const ExprId ones = Value(Scalar::kFloat, {1, 1, 1});
  EXPECT_THAT(Evaluated(Call(Intrinsic::kDot, FloatType(1), {a, ones})), ElementsAre(0));
}

TEST_F(Intrinsics, MulInAllNineForms) {
  const auto mul = [&](TypeId type, ExprId a, ExprId b) {
    return Evaluated(Call(Intrinsic::kMul, type, {a, b}));
  };
  const auto v2 = [&] { return Value(Scalar::kFloat, {10, 100}); };
  const auto v3 = [&] { return Value(Scalar::kFloat, {1, 10, 100}); };
  const auto m = [&] { return Matrix(2, 3, {1, 2, 3, 4, 5, 6}); };
  const auto s = [&] { return build.Float(2); };
  EXPECT_THAT(mul(FloatType(1), s(), s()), ElementsAre(4));
  EXPECT_THAT(mul(FloatType(2), s(), v2()), ElementsAre(20, 200));
  EXPECT_THAT(mul(FloatType(2), v2(), s()), ElementsAre(20, 200));
  EXPECT_THAT(mul(program.types.Matrix(Scalar::kFloat, 2, 3), s(), m()),
              ElementsAre(2, 4, 6, 8, 10, 12));
  EXPECT_THAT(mul(program.types.Matrix(Scalar::kFloat, 2, 3), m(), s()),
              ElementsAre(2, 4, 6, 8, 10, 12));
  EXPECT_THAT(mul(FloatType(1), v2(), v2()), ElementsAre(10100));
  EXPECT_THAT(mul(FloatType(3), v2(), m()), ElementsAre(410, 520, 630));
  EXPECT_THAT(mul(FloatType(2), m(), v3()), ElementsAre(321, 654));
  EXPECT_THAT(
      mul(program.types.Matrix(Scalar::kFloat, 2, 2), m(), Matrix(3, 2, {1, 0, 0, 1, 1, 1})),
      ElementsAre(4, 5, 10, 11));
}

TEST_F(Intrinsics, TransposeAndDeterminant) {
  EXPECT_THAT(Evaluated(Call(Intrinsic::kTranspose, program.types.Matrix(Scalar::kFloat, 3, 2),
                             {Matrix(2, 3, {1, 2, 3, 4, 5, 6})})),
              ElementsAre(1, 4, 2, 5, 3, 6));
  const auto determinant = [&](int size, const Numbers& m) {
    return Evaluated(Call(Intrinsic::kDeterminant, FloatType(1), {Matrix(size, size, m)}))[0];
  };
  EXPECT_EQ(determinant(2, {1, 2, 3, 4}), -2);
  EXPECT_EQ(determinant(3, {2, 0, 1, 1, 3, 2, 1, 1, 4}), 18);
  EXPECT_EQ(determinant(4, {1, 0, 0, 5, 0, 2, 0, 6, 0, 0, 3, 7, 1, 1, 1, 4}), -38);
}

TEST_F(Intrinsics, Geometry) {
  const auto v = [&](const Numbers& components) { return Value(Scalar::kFloat, components); };
  EXPECT_THAT(Evaluated(Call(Intrinsic::kLength, FloatType(1), {v({3, 4})})), ElementsAre(5));
  EXPECT_THAT(Evaluated(Call(Intrinsic::kDistance, FloatType(1), {v({1, 1}), v({4, 5})})),
              ElementsAre(5));
  EXPECT_THAT(Evaluated(Call(Intrinsic::kNormalize, FloatType(2), {v({0, -4})})),
              ElementsAre(0, -1));
  EXPECT_TRUE(std::isnan(Evaluated(Call(Intrinsic::kNormalize, FloatType(2), {v({0, 0})}))[0]));
  EXPECT_THAT(Evaluated(Call(Intrinsic::kReflect, FloatType(2), {v({1, -1}), v({0, 1})})),
              ElementsAre(1, 1));
  EXPECT_THAT(
      Evaluated(Call(Intrinsic::kFaceforward, FloatType(2), {v({0, 1}), v({0, -1}), v({0, 1})})),
      ElementsAre(0, 1));
  EXPECT_THAT(
      Evaluated(Call(Intrinsic::kFaceforward, FloatType(2), {v({0, 1}), v({0, 1}), v({0, 1})})),
      ElementsAre(0, -1));
}

TEST_F(Intrinsics, RefractBendsOrGivesZero) {
  const auto refract = [&](const Numbers& i, double eta) {
    return Evaluated(Call(Intrinsic::kRefract, FloatType(2),
                          {Value(Scalar::kFloat, i), Value(Scalar::kFloat, {0, 1}),
                           build.Float(static_cast<float>(eta))}));
  };
  EXPECT_THAT(refract({0, -1}, 0.5), ElementsAre(0, -1));
  // sin 0.6, cos 0.8, eta 0.5: sin 0.3, cos sqrt(0.91).
  EXPECT_THAT(refract({0.6, -0.8}, 0.5), Pointwise(DoubleNear(1e-6), {0.3, -0.953939201}));
  EXPECT_THAT(refract({0.8, -0.6}, 2), ElementsAre(0, 0));  // total reflection
}

TEST_F(Intrinsics, LitRaisesToThePower) {
  const auto lit = [&](double l, double h, double m) {
    return Evaluated(
        Call(Intrinsic::kLit, FloatType(4),
             {Value(Scalar::kFloat, {l}), Value(Scalar::kFloat, {h}), Value(Scalar::kFloat, {m})}));
  };
  EXPECT_THAT(lit(0.5, 0.5, 3), ElementsAre(1, 0.5, 0.125, 1));
  EXPECT_THAT(lit(-0.5, 0.5, 3), ElementsAre(1, 0, 0, 1));
  EXPECT_THAT(lit(0.5, -0.5, 3), ElementsAre(1, 0.5, 0, 1));
}

TEST_F(Intrinsics, DstAndColors) {
  EXPECT_THAT(
      Evaluated(Call(Intrinsic::kDst, FloatType(4),
                     {Value(Scalar::kFloat, {9, 2, 3, 9}), Value(Scalar::kFloat, {9, 5, 9, 7})})),
      ElementsAre(1, 10, 3, 7));
  EXPECT_THAT(Evaluated(Call(Intrinsic::kD3dColorToUbyte4, program.types.Vector(Scalar::kInt, 4),
                             {Value(Scalar::kFloat, {1, 0.5, 3 / 255.0, 0})})),
              ElementsAre(3, 127, 255, 0));
}

TEST_F(Intrinsics, DoublesAreComputedInDouble) {
  const TypeId type = program.types.Vector(Scalar::kDouble, 2);
  const ExprId a = Value(Scalar::kDouble, {1e300, 0.1});
  EXPECT_EQ(Evaluated(build.BinaryOf(BinaryOp::kMul, a, Value(Scalar::kDouble, {10, 0.1}))),
            (Numbers{1e301, 0.1 * 0.1}));
  EXPECT_EQ(Evaluated(Call(Intrinsic::kAbs, type, {Value(Scalar::kDouble, {-0.1, 1})})),
            (Numbers{0.1, 1}));
}

TEST_F(Intrinsics, SignaturesAreChecked) {
  const TypeId f3 = FloatType(3);
  const TypeId f = FloatType(1);
  TypeTable& types = program.types;
  EXPECT_NE(CheckIntrinsic(types, Intrinsic::kCross, f3, {f3, FloatType(4)}), std::nullopt);
  EXPECT_NE(CheckIntrinsic(types, Intrinsic::kAbs, f, {f3}), std::nullopt);
  EXPECT_NE(CheckIntrinsic(types, Intrinsic::kAbs, f3, {f3, f3}), std::nullopt);
  EXPECT_NE(CheckIntrinsic(types, Intrinsic::kSin, f, {types.Make(Scalar::kInt)}), std::nullopt);
  EXPECT_NE(CheckIntrinsic(types, Intrinsic::kMul, f3, {f3, types.Matrix(Scalar::kFloat, 4, 3)}),
            std::nullopt);
  EXPECT_NE(CheckIntrinsic(types, Intrinsic::kTranspose, types.Matrix(Scalar::kFloat, 2, 3),
                           {types.Matrix(Scalar::kFloat, 2, 3)}),
            std::nullopt);
  EXPECT_NE(CheckIntrinsic(types, Intrinsic::kSincos, f, {f, f, f}), std::nullopt);
  EXPECT_EQ(CheckIntrinsic(types, Intrinsic::kSincos, types.Void(), {f, f, f}), std::nullopt);
  EXPECT_EQ(CheckIntrinsic(types, Intrinsic::kRefract, f3, {f3, f3, f}), std::nullopt);
}

}  // namespace
}  // namespace clipc::ir
