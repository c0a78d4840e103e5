// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/constants.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "ir/builder.h"
#include "ir/intrinsic_list.h"

namespace clipc::glsl {
namespace {

using namespace ir;

class ConstantsTest : public ::testing::Test {
 protected:
  VarId Constant(ExprId value) {
    const VarId var =
        b_.Local("constant" + std::to_string(program_.vars.size()), program_.exprs[value].type);
    program_.vars[var].storage = Storage::kConstant;
    program_.vars[var].init = value;
    return var;
  }
  ExprId Sine() { return b_.IntrinsicOf(Intrinsic::kSin, float_, {b_.Float(1)}); }
  ExprId Matrix(float value) { return b_.Ref(Constant(b_.SplatTo(matrix_, b_.Float(value)))); }
  bool Has(ExprId expr, const char* target = "glsl450") {
    const Target wanted = *Target::Parse(target);
    const legalize::Needs needs = wanted.Needs();
    return Constants(program_, wanted, needs).Has(expr);
  }

  Program program_;
  Builder b_{program_};
  const TypeId float_ = program_.types.Make(Scalar::kFloat);
  const TypeId matrix_ = program_.types.Matrix(Scalar::kFloat, 3, 3);
};

TEST_F(ConstantsTest, HasOperatorsAndFunctionsOfLiterals) {
  EXPECT_TRUE(Has(b_.BinaryOf(BinaryOp::kAdd, Sine(), b_.Float(2))));
  EXPECT_TRUE(Has(b_.ConvertTo(Scalar::kInt, Sine())));
}

TEST_F(ConstantsTest, HasConstantsOnlyWhoseValueIsOne) {
  EXPECT_FALSE(Has(b_.Ref(b_.Local("any", float_))));
  EXPECT_TRUE(Has(b_.Ref(Constant(b_.Ref(Constant(b_.Float(1)))))));
  const ExprId infinity = b_.Float(std::numeric_limits<float>::infinity());
  EXPECT_FALSE(Has(b_.Ref(Constant(b_.Ref(Constant(infinity))))));
}

TEST_F(ConstantsTest, KnowsWhatGlslangDoesNotCompute) {
  const auto call = [&](Intrinsic op, TypeId type, ExprId argument) {
    return b_.IntrinsicOf(op, type, {argument});
  };
  EXPECT_FALSE(Has(call(Intrinsic::kTanh, float_, b_.Float(1))));
  EXPECT_FALSE(Has(call(Intrinsic::kTranspose, matrix_, Matrix(1))));
  EXPECT_FALSE(Has(call(Intrinsic::kDeterminant, float_, Matrix(1))));
  EXPECT_FALSE(Has(b_.BinaryOf(BinaryOp::kMul, Matrix(1), Matrix(2))));
  EXPECT_TRUE(Has(b_.BinaryOf(BinaryOp::kAdd, Matrix(1), Matrix(2))));
}

// GLSL 1.20 has no roundEven, so a function of the writer's takes its place.
TEST_F(ConstantsTest, HasNoCallsOfHelperFunctions) {
  const ExprId rounded = b_.IntrinsicOf(Intrinsic::kTrunc, float_, {Sine()});
  EXPECT_TRUE(Has(rounded));
  EXPECT_FALSE(Has(rounded, "glsl120"));
  EXPECT_TRUE(Has(b_.ZeroOf(program_.types.Array(float_, 16))));
  EXPECT_FALSE(Has(b_.ZeroOf(program_.types.Array(float_, 17))));
}

TEST_F(ConstantsTest, HasMatricesOfScalarsThatMayBeRepeated) {
  EXPECT_TRUE(Has(b_.SplatTo(matrix_, b_.Float(2))));
  EXPECT_FALSE(Has(b_.SplatTo(matrix_, Sine())));
  EXPECT_TRUE(Has(b_.BinaryOf(BinaryOp::kMul, Matrix(1), b_.SplatTo(matrix_, Sine()))));
}

// Each constant names the one before 200 times: with the values walked again at each name, this
// test takes an hour.
TEST_F(ConstantsTest, WalksTheValueOfAConstantOnce) {
  VarId constant = Constant(b_.Float(1));
  for (int i = 0; i < 5; ++i) {
    ExprId sum = b_.Ref(constant);
    for (int j = 0; j < 200; ++j) sum = b_.BinaryOf(BinaryOp::kAdd, sum, b_.Ref(constant));
    constant = Constant(sum);
  }
  EXPECT_TRUE(Has(b_.Ref(constant)));
}

}  // namespace
}  // namespace clipc::glsl
