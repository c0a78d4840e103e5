// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ir/test_evaluator.h"

// Statements and calls; evaluate_test.cpp has the values.
namespace clipc::ir {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// ---- control flow

TEST_F(Evaluator, LoopsBreakAndContinue) {
  const VarId i = Local("i", Int());
  const VarId sum = Local("sum", Int());
  const auto is = [&](int value) {
    return build.BinaryOf(BinaryOp::kEqual, build.Ref(i), build.Int(value));
  };
  const StmtId body = build.BlockOf(std::vector<StmtId>{
      build.Stmt(If{is(3), build.Stmt(Continue{}), {}}),
      build.Stmt(If{is(6), build.Stmt(Break{}), {}}), Set(sum, build.Ref(i), BinaryOp::kAdd)});
  shader.Append({shader.DeclareVar(sum, build.Int(0)),
                 build.Stmt(For{shader.Stmts({shader.DeclareVar(i, build.Int(0))}),
                                build.BinaryOf(BinaryOp::kLess, build.Ref(i), build.Int(10)),
                                build.UnaryOf(UnaryOp::kPreIncrement, build.Ref(i)), body})});
  EXPECT_EQ(Result(ToFloat(build.Ref(sum))), 0 + 1 + 2 + 4 + 5);
}

TEST_F(Evaluator, DoWhileRunsOnce) {
  const VarId i = Local("i", Int());
  shader.Append({shader.DeclareVar(i, build.Int(0)),
                 build.Stmt(DoWhile{Set(i, build.Int(1), BinaryOp::kAdd), build.Bool(false)}),
                 build.Stmt(While{build.Bool(false), Set(i, build.Int(1), BinaryOp::kAdd)})});
  EXPECT_EQ(Result(ToFloat(build.Ref(i))), 1);
}

TEST_F(Evaluator, SwitchFallsThroughAndHasADefault) {
  const VarId i = Local("i", Int());
  const VarId sum = Local("sum", Int());
  const auto arm = [&](std::vector<int> labels, bool is_default, std::vector<StmtId> body) {
    std::vector<ExprId> literals;
    for (int label : labels) literals.push_back(build.Int(label));
    return SwitchCase{shader.expr_lists.Add(std::span<const ExprId>(literals)), is_default,
                      shader.Stmts(body)};
  };
  const std::vector<SwitchCase> arms = {
      arm({0, 1}, false, {Set(sum, build.Int(1), BinaryOp::kAdd)}),
      arm({}, true, {Set(sum, build.Int(10), BinaryOp::kAdd), build.Stmt(Break{})}),
      arm({2}, false, {Set(sum, build.Int(100), BinaryOp::kAdd), build.Stmt(Break{})})};
  const StmtId the_switch =
      build.Stmt(Switch{build.Ref(i), shader.switch_cases.Add(std::span<const SwitchCase>(arms))});
  shader.Append({shader.DeclareVar(sum, build.Int(0)),
                 build.Stmt(For{shader.Stmts({shader.DeclareVar(i, build.Int(0))}),
                                build.BinaryOf(BinaryOp::kLess, build.Ref(i), build.Int(4)),
                                build.UnaryOf(UnaryOp::kPreIncrement, build.Ref(i)), the_switch})});
  EXPECT_EQ(Result(ToFloat(build.Ref(sum))), 11 + 11 + 100 + 10);
}

TEST_F(Evaluator, InfiniteLoopsEndWithAnError) {
  options.step_limit = 1000;
  shader.Append({build.Stmt(While{build.Bool(true), build.BlockOf({})}),
                 shader.Return(build.Ref(shader.parameter))});
  EXPECT_TRUE(Run().empty());
  EXPECT_THAT(shader.error, HasSubstr("step limit"));
}

// ---- calls

TEST_F(Evaluator, OutAndInoutAreCopiedAfterTheCall) {
  // float f(inout float a, out float b) { a += 1; b = counter; counter = 5; return a; } called with
  // the global itself
  const VarId a = shader.AddVar("a", Float(), Storage::kInOut);
  const VarId out = shader.AddVar("b", Float(), Storage::kOut);
  const FunctionId f = shader.AddFunction(
      "f", Float(), {a, out},
      {Set(a, build.Float(1), BinaryOp::kAdd), Set(out, build.Ref(shader.counter)),
       Set(shader.counter, build.Float(5)), shader.Return(build.Ref(a))});
  const VarId x = Local("x", Float4());
  const std::vector<ExprId> arguments = {build.Ref(shader.counter),
                                         build.Swizzled(build.Ref(x), {2})};
  const ExprId call = build.CallOf(f, arguments);
  shader.Append(
      {shader.DeclareVar(x, build.Ref(shader.parameter)),
       build.Eval(build.AssignTo(build.Swizzled(build.Ref(x), {0}), call)),
       build.Eval(build.AssignTo(build.Swizzled(build.Ref(x), {1}), build.Ref(shader.counter))),
       shader.Return(build.Ref(x))});
  // The call sees counter == 1 and gives a == 2; copied out, counter is 2, not 5.
  EXPECT_THAT(Run(), ElementsAre(2, 2, 1, 4));
}

TEST_F(Evaluator, ACallMayBeAnArgumentOfTheSameFunction) {
  const VarId x = shader.AddVar("x", Float(), Storage::kIn);
  const VarId y = shader.AddVar("y", Float(), Storage::kIn);
  const FunctionId sub = shader.AddFunction(
      "sub", Float(), {x, y},
      {shader.Return(build.BinaryOf(BinaryOp::kSub, build.Ref(x), build.Ref(y)))});
  const auto call = [&](ExprId left, ExprId right) {
    return build.CallOf(sub, std::vector<ExprId>{left, right});
  };
  EXPECT_EQ(Result(call(build.Float(10), call(build.Float(7), build.Float(2)))), 5);
}

TEST_F(Evaluator, EarlyReturnLeavesLoopsAndFunctions) {
  shader.Append({build.Stmt(While{build.Bool(true), build.BlockOf(std::vector<StmtId>{shader.Return(
                                                        build.Ref(shader.parameter))})}),
                 shader.Return(shader.Splat4(build.Float(0)))});
  EXPECT_THAT(Run(), ElementsAre(1, 2, 3, 4));
}

TEST_F(Evaluator, ShortCircuitSkipsAndPlainLogicDoesNot) {
  const auto bump = [&] {
    return build.BinaryOf(BinaryOp::kGreater,
                          build.UnaryOf(UnaryOp::kPreIncrement, build.Ref(shader.counter)),
                          build.Float(0));
  };
  const VarId flag = Local("flag", shader.types.Make(Scalar::kBool));
  shader.Append({shader.DeclareVar(
                     flag, build.BinaryOf(BinaryOp::kShortCircuitAnd, build.Bool(false), bump())),
                 Set(flag, build.BinaryOf(BinaryOp::kShortCircuitOr, build.Bool(true), bump())),
                 Set(flag, build.BinaryOf(BinaryOp::kLogicalAnd, build.Bool(false), bump()))});
  EXPECT_EQ(Result(build.Ref(shader.counter)), 2);
}

TEST_F(Evaluator, OnlyTheChosenSideOfAConditionalRuns) {
  const auto bump = [&] {
    return build.UnaryOf(UnaryOp::kPreIncrement, build.Ref(shader.counter));
  };
  EXPECT_EQ(Result(build.Add(Float(), Conditional{build.Bool(true), bump(), bump()})), 2);
}

}  // namespace
}  // namespace clipc::ir
