// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/legalize/ranges.h"

#include <string>

#include <gtest/gtest.h>

#include "ir/builder.h"

namespace clipc::glsl {
namespace {

using namespace ir;

class RangesTest : public ::testing::Test {
 protected:
  VarId Constant(ExprId value) {
    const VarId var = b_.Local("constant" + std::to_string(program_.vars.size()), float_);
    program_.vars[var].storage = Storage::kConstant;
    program_.vars[var].init = value;
    return var;
  }
  // The sum of `times` references to the variable.
  ExprId SumOf(VarId var, int times) {
    ExprId sum = b_.Ref(var);
    for (int i = 1; i < times; ++i) sum = b_.BinaryOf(BinaryOp::kAdd, sum, b_.Ref(var));
    return sum;
  }
  void ExpectRange(ExprId expr, double least, double most) {
    const Range range = Ranges(program_).Of(expr);
    EXPECT_EQ(range.least, least);
    EXPECT_EQ(range.most, most);
  }

  Program program_;
  Builder b_{program_};
  const TypeId float_ = program_.types.Make(Scalar::kFloat);
};

TEST_F(RangesTest, BoundsOperatorsOfWhatIsKnown) {
  const ExprId unit =
      b_.IntrinsicOf(Intrinsic::kSaturate, float_, {b_.Ref(b_.Local("any", float_))});
  const ExprId scaled = b_.BinaryOf(BinaryOp::kMul, unit, b_.Float(-6));
  ExpectRange(b_.BinaryOf(BinaryOp::kAdd, scaled, b_.Float(2)), -4, 2);
}

TEST_F(RangesTest, KnowsNothingOfVariables) {
  EXPECT_FALSE(Ranges(program_).Of(b_.Ref(b_.Local("any", float_))).IsKnown());
}

TEST_F(RangesTest, FollowsConstants) {
  ExpectRange(SumOf(Constant(SumOf(Constant(b_.Float(1.5f)), 2)), 2), 6, 6);
}

// Each constant names the one before 200 times: with the values walked again at each name, this
// test takes an hour. Constants that are nested deeper than the stack allows have any value.
TEST_F(RangesTest, WalksTheValueOfAConstantOnce) {
  VarId constant = Constant(b_.Float(1));
  for (int i = 0; i < 4; ++i) constant = Constant(SumOf(constant, 200));
  EXPECT_FALSE(Ranges(program_).Of(SumOf(constant, 200)).IsKnown());
}

}  // namespace
}  // namespace clipc::glsl
