// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/typing/constant.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "frontend/typing/program_for_test.h"
#include "ir/intrinsic_list.h"

namespace clipc::typing {
namespace {

using ir::BinaryOp;
using ir::ExprId;

class ConstantTest : public testing::Test {
 protected:
  std::vector<double> Components(ExprId expr) {
    const auto constant = EvaluateConstant(test_.program, expr);
    return constant ? constant->components : std::vector<double>{};
  }
  std::optional<std::int64_t> Integer(BinaryOp op, std::int32_t left, std::int32_t right) {
    return EvaluateInteger(test_.program, make_.BinaryOf(op, make_.Int(left), make_.Int(right)));
  }
  std::optional<std::int64_t> Unsigned(BinaryOp op, std::uint32_t left, std::uint32_t right) {
    return EvaluateInteger(test_.program, make_.BinaryOf(op, make_.Uint(left), make_.Uint(right)));
  }
  ExprId Float2(float x, float y) {
    return make_.ConstructOf(test_.Type("float2"), {make_.Float(x), make_.Float(y)});
  }

  ProgramForTest test_;
  ir::Builder make_{test_.program};
};

constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();

TEST_F(ConstantTest, IntegersWrapAround) {
  EXPECT_EQ(Integer(BinaryOp::kAdd, kMost, 1), kLeast);
  EXPECT_EQ(Integer(BinaryOp::kMul, kMost, kMost), 1);
  EXPECT_EQ(Integer(BinaryOp::kSub, kLeast, 1), kMost);
  EXPECT_EQ(Unsigned(BinaryOp::kSub, 0, 1), 0xffffffff);
  EXPECT_EQ(EvaluateInteger(test_.program, make_.UnaryOf(ir::UnaryOp::kNegate, make_.Int(kLeast))),
            kLeast);
  EXPECT_EQ(EvaluateInteger(test_.program, make_.UnaryOf(ir::UnaryOp::kComplement, make_.Uint(0))),
            0xffffffff);
}

TEST_F(ConstantTest, DivisionTruncates) {
  EXPECT_EQ(Integer(BinaryOp::kDiv, -7, 2), -3);
  EXPECT_EQ(Integer(BinaryOp::kMod, -7, 2), -1);
  EXPECT_EQ(Integer(BinaryOp::kDiv, kLeast, -1), kLeast);
  EXPECT_EQ(Integer(BinaryOp::kMod, kLeast, -1), 0);
  EXPECT_EQ(Unsigned(BinaryOp::kDiv, 0xffffffff, 2), 0x7fffffff);
}

TEST_F(ConstantTest, DivisionByZeroIsNoConstant) {
  EXPECT_EQ(Integer(BinaryOp::kDiv, 1, 0), std::nullopt);
  EXPECT_EQ(Unsigned(BinaryOp::kMod, 1, 0), std::nullopt);
  EXPECT_EQ(Components(make_.BinaryOf(BinaryOp::kDiv, make_.Float(1), make_.Float(0))),
            std::vector<double>{std::numeric_limits<double>::infinity()});
}

TEST_F(ConstantTest, ShiftCountsAreModulo32) {
  EXPECT_EQ(Integer(BinaryOp::kShiftLeft, 1, 33), 2);
  EXPECT_EQ(Integer(BinaryOp::kShiftLeft, 1, 31), kLeast);
  EXPECT_EQ(Integer(BinaryOp::kShiftRight, -8, 1), -4);
  EXPECT_EQ(Integer(BinaryOp::kShiftRight, -8, -1), -1);
  EXPECT_EQ(Unsigned(BinaryOp::kShiftRight, 0x80000000, 31), 1);
}

TEST_F(ConstantTest, FloatsRoundAfterEachOperation) {
  const ExprId sum = make_.BinaryOf(BinaryOp::kAdd, make_.Float(16777216.0f), make_.Float(1.0f));
  EXPECT_EQ(Components(make_.BinaryOf(BinaryOp::kAdd, sum, make_.Float(1.0f))),
            std::vector<double>{16777216.0});
  EXPECT_EQ(Components(make_.BinaryOf(BinaryOp::kMul, make_.Float(0.1f), make_.Float(3.0f))),
            std::vector<double>{static_cast<double>(0.1f * 3.0f)});
  EXPECT_EQ(Components(make_.ConvertTo(ir::Scalar::kInt, make_.Float(-2.7f))),
            std::vector<double>{-2.0});
  EXPECT_EQ(Components(make_.ConvertTo(ir::Scalar::kInt, make_.Float(1e20f))),
            std::vector<double>{kMost});
  EXPECT_EQ(Components(make_.ConvertTo(ir::Scalar::kUint, make_.Float(NAN))),
            std::vector<double>{0.0});
}

TEST_F(ConstantTest, Shapes) {
  EXPECT_EQ(Components(Float2(1, 2)), (std::vector<double>{1, 2}));
  EXPECT_EQ(Components(make_.Swizzled(Float2(1, 2), {1, 0, 1})), (std::vector<double>{2, 1, 2}));
  EXPECT_EQ(Components(make_.SplatTo(test_.Type("float2x2"), make_.Float(3))),
            (std::vector<double>{3, 3, 3, 3}));
  EXPECT_EQ(Components(make_.ZeroOf(test_.Type("float3"))), (std::vector<double>{0, 0, 0}));
  const ExprId matrix = make_.ConstructOf(test_.Type("float2x2"), {Float2(1, 2), Float2(3, 4)});
  EXPECT_EQ(Components(make_.At(Clone(test_.program, matrix), 1u)), (std::vector<double>{3, 4}));
  EXPECT_EQ(Components(make_.Add(test_.Type("float2x1"),
                                 ir::MatrixTruncate{Clone(test_.program, matrix)})),
            (std::vector<double>{1, 3}));
  EXPECT_EQ(
      Components(make_.Add(test_.Type("float2"), ir::MatrixSwizzle{matrix, {1, 0}, {0, 1}, 2})),
      (std::vector<double>{3, 2}));
  EXPECT_EQ(Components(make_.At(Float2(1, 2), 2u)), std::vector<double>{});
}

TEST_F(ConstantTest, ChoicesAndIntrinsics) {
  EXPECT_EQ(
      Components(make_.Add(test_.Type("float"),
                           ir::Conditional{make_.Bool(false), make_.Float(1), make_.Float(2)})),
      std::vector<double>{2});
  EXPECT_EQ(Components(make_.IntrinsicOf(ir::Intrinsic::kMax, test_.Type("float2"),
                                         {Float2(1, 5), Float2(2, 3)})),
            (std::vector<double>{2, 5}));
  EXPECT_EQ(Components(make_.IntrinsicOf(ir::Intrinsic::kDot, test_.Type("float"),
                                         {Float2(1, 5), Float2(2, 3)})),
            std::vector<double>{17});
  EXPECT_EQ(
      Components(make_.IntrinsicOf(ir::Intrinsic::kAsUint, test_.Type("uint"), {make_.Float(1)})),
      std::vector<double>{0x3f800000});
  EXPECT_EQ(Components(make_.IntrinsicOf(ir::Intrinsic::kAsDouble, test_.Type("double"),
                                         {make_.Uint(0), make_.Uint(0)})),
            std::vector<double>{});
}

TEST_F(ConstantTest, SeesThroughConstantVariables) {
  const ir::VarId k = test_.Constant("k", make_.Int(4));
  EXPECT_EQ(
      EvaluateInteger(test_.program, make_.BinaryOf(BinaryOp::kAdd, make_.Ref(k), make_.Int(1))),
      5);
  EXPECT_EQ(EvaluateInteger(test_.program, test_.Var("x", "int")), std::nullopt);
  EXPECT_EQ(EvaluateInteger(test_.program, make_.Float(1)), std::nullopt);
}

TEST_F(ConstantTest, ReadsConstantArraysAndStructs) {
  ir::TypeTable& types = test_.program.types;
  const ir::TypeId array = types.Array(test_.Type("float2"), 2);
  const ir::VarId a = test_.Constant("a", make_.ConstructOf(array, {Float2(1, 2), Float2(3, 4)}));
  EXPECT_EQ(Components(make_.At(make_.Ref(a), 1u)), (std::vector<double>{3, 4}));
  EXPECT_EQ(Components(make_.At(make_.Ref(a), 2u)), std::vector<double>{});
  EXPECT_EQ(Components(make_.Ref(a)), (std::vector<double>{1, 2, 3, 4}));
  const ir::TypeId light = test_.Struct("Light", {test_.Type("float"), array});
  const ir::VarId s = test_.Constant("s", make_.ConstructOf(light, {make_.Float(7), make_.Ref(a)}));
  EXPECT_EQ(Components(make_.At(make_.Field(make_.Ref(s), 1), 0u)), (std::vector<double>{1, 2}));
  const ir::VarId z = test_.Constant("z", make_.ZeroOf(light));
  EXPECT_EQ(Components(make_.At(make_.Field(make_.Ref(z), 1), 1u)), (std::vector<double>{0, 0}));
  EXPECT_EQ(Components(make_.Ref(z)), (std::vector<double>{0, 0, 0, 0, 0}));
}

// Each constant names the one before twice: 2^64 additions for a walk that remembers nothing.
TEST_F(ConstantTest, ChainsOfConstantsAreLinear) {
  ir::VarId last = test_.Constant("first", make_.Uint(1));
  for (int i = 0; i < 64; ++i)
    last = test_.Constant("next", make_.BinaryOf(BinaryOp::kAdd, make_.Ref(last), make_.Ref(last)));
  EXPECT_EQ(EvaluateInteger(test_.program, make_.Ref(last)), 0);
  const ir::TypeId pair = test_.program.types.Array(test_.Type("uint"), 2);
  ir::VarId array = test_.Constant("a", make_.ConstructOf(pair, {make_.Uint(1), make_.Uint(1)}));
  for (int i = 0; i < 64; ++i) {
    const auto sum = [&] {
      return make_.BinaryOf(BinaryOp::kAdd, make_.At(make_.Ref(array), 0u),
                            make_.At(make_.Ref(array), 1u));
    };
    array = test_.Constant("a", make_.ConstructOf(pair, {sum(), sum()}));
  }
  EXPECT_EQ(EvaluateInteger(test_.program, make_.At(make_.Ref(array), 0u)), std::nullopt);
}

TEST_F(ConstantTest, LongChainsAndLargeTablesEnd) {
  ir::VarId last = test_.Constant("first", make_.Uint(1));
  for (int i = 0; i < 100000; ++i) last = test_.Constant("next", make_.Ref(last));
  EXPECT_EQ(EvaluateInteger(test_.program, make_.Ref(last)), std::nullopt);
  std::vector<ExprId> elements;
  for (int i = 0; i < 20000; ++i) elements.push_back(make_.Float(1));
  const ir::TypeId table = test_.program.types.Array(test_.Type("float"), 20000);
  EXPECT_EQ(Components(make_.ConstructOf(table, elements)).size(), 20000u);
}

}  // namespace
}  // namespace clipc::typing
