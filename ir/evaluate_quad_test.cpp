// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ir/intrinsic_list.h"
#include "ir/test_evaluator.h"

// Pixels that run in quads.
namespace clipc::ir {
namespace {

using testing::Each;
using testing::ElementsAre;

class Quad : public Evaluator {
 protected:
  // The entry's result in each pixel, when p.x differs among them: {1, 3, 10, 20}.
  std::vector<double> RunPixels(ExprId scalar) {
    shader.Append({shader.Return(shader.Splat4(scalar))});
    std::array<EvalInputs, kQuadPixels> pixels;
    constexpr std::array<float, kQuadPixels> kValues{1, 3, 10, 20};
    for (std::size_t i = 0; i < kQuadPixels; ++i) {
      pixels[i].values.push_back({BitsOf(kValues[i])});
      pixels[i].read_object = shader.read_object;
    }
    std::vector<double> numbers;
    for (const EvalResult& result : RunQuad(shader, pixels, options)) {
      EXPECT_EQ(result.error, "");
      numbers.push_back(result.outputs.numbers[0][0]);
      discarded.push_back(result.outputs.is_discarded);
    }
    return numbers;
  }
  ExprId X() { return build.Swizzled(build.Ref(shader.parameter), {0}); }
  ExprId Of(Intrinsic op, ExprId value) { return build.IntrinsicOf(op, Float(), {value}); }

  std::vector<bool> discarded;
};

TEST_F(Quad, DerivativesAreDifferencesInRowsAndColumns) {
  EXPECT_THAT(RunPixels(Of(Intrinsic::kDdx, X())), ElementsAre(2, 2, 10, 10));
}

TEST_F(Quad, TheWindowGrowsDownwards) {
  EXPECT_THAT(RunPixels(Of(Intrinsic::kDdy, X())), ElementsAre(9, 17, 9, 17));
}

TEST_F(Quad, WidthIsTheSumOfBoth) {
  const ExprId negative = build.UnaryOf(UnaryOp::kNegate, X());
  EXPECT_THAT(RunPixels(Of(Intrinsic::kFwidth, negative)), ElementsAre(11, 19, 19, 27));
}

TEST_F(Quad, DerivativesOfDerivatives) {
  EXPECT_THAT(RunPixels(Of(Intrinsic::kDdx, Of(Intrinsic::kDdy, X()))), Each(8));
}

TEST_F(Quad, DerivativesInDouble) {
  options.in_double = true;
  EXPECT_THAT(RunPixels(Of(Intrinsic::kDdx, X())), ElementsAre(2, 2, 10, 10));
}

// Where a pixel does not come by, the others have no derivative.
TEST_F(Quad, DerivativesInVaryingFlowAreUndefined) {
  options.undefined = 5;
  const VarId v = Local("v", Float());
  const ExprId condition = build.BinaryOf(BinaryOp::kLess, X(), build.Float(15));
  shader.Append({shader.DeclareVar(v, build.Float(0)),
                 build.Stmt(If{condition, Set(v, Of(Intrinsic::kDdx, X())), {}})});
  EXPECT_THAT(RunPixels(build.Ref(v)), ElementsAre(5, 5, 5, 0));
}

// Iteration i of one pixel is run with iteration i of another, however often each has run the loop.
TEST_F(Quad, IterationsMeet) {
  const VarId i = Local("i", Float()), sum = Local("sum", Float());
  const ExprId condition = build.BinaryOf(BinaryOp::kLess, build.Ref(i), build.Float(3));
  const ExprId value = build.BinaryOf(BinaryOp::kMul, X(), build.Ref(i));
  const ExprId step = build.AssignTo(build.Ref(i), build.Float(1), BinaryOp::kAdd);
  const StmtId body = Set(sum, Of(Intrinsic::kDdx, value), BinaryOp::kAdd);
  shader.Append({shader.DeclareVar(sum, build.Float(0)), shader.DeclareVar(i, build.Float(0)),
                 build.Stmt(For{{}, condition, step, body})});
  EXPECT_THAT(RunPixels(build.Ref(sum)), ElementsAre(6, 6, 30, 30));
}

TEST_F(Quad, CallsMeet) {
  const VarId x = shader.AddVar("x", Float(), Storage::kIn);
  const FunctionId change = shader.AddFunction("change", Float(), {x},
                                               {shader.Return(Of(Intrinsic::kDdx, build.Ref(x)))});
  const auto call = [&](ExprId argument) { return build.CallOf(change, std::span(&argument, 1)); };
  EXPECT_THAT(RunPixels(build.BinaryOf(BinaryOp::kAdd, call(X()), call(build.Float(7)))),
              ElementsAre(2, 2, 10, 10));
}

TEST_F(Quad, DiscardedPixelsRunOn) {
  const ExprId condition = build.BinaryOf(BinaryOp::kLess, X(), build.Float(2));
  shader.Append({build.Stmt(If{condition, build.Stmt(Discard{}), {}})});
  EXPECT_THAT(RunPixels(Of(Intrinsic::kDdx, X())), ElementsAre(2, 2, 10, 10));
  EXPECT_THAT(discarded, ElementsAre(true, false, false, false));
}

}  // namespace
}  // namespace clipc::ir
