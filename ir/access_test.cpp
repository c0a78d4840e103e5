// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/access.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ir/intrinsic_list.h"
#include "ir/test_program.h"

namespace clipc::ir {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class Access : public testing::Test {
 protected:
  ExprId Counter() { return build.Ref(shader.counter); }
  ExprId Scale() { return build.Ref(shader.scale); }
  ExprId Twice(ExprId x) { return build.BinaryOf(BinaryOp::kMul, build.Float(2), x); }
  ExprId Increment(ExprId x) { return build.UnaryOf(UnaryOp::kPostIncrement, x); }
  ExprId Intrinsic2(Intrinsic op, ExprId x, ExprId y) {
    return build.IntrinsicOf(op, shader.types.Make(Scalar::kFloat), {x, y});
  }
  std::vector<ExprId> Writes(ExprId expr) {
    std::vector<ExprId> targets;
    ForEachWrite(shader, expr, [&](ExprId target) { targets.push_back(target); });
    return targets;
  }
  // float name(inout float x) { <body> }
  FunctionId Function(Storage storage, std::vector<StmtId> body) {
    const VarId x = shader.AddVar("x", shader.types.Make(Scalar::kFloat), storage);
    return shader.AddFunction("f", shader.types.Void(), {x}, std::move(body));
  }

  TestProgram shader;
  Builder& build = shader.build;
};

TEST_F(Access, PathsStartAtAVariable) {
  const ExprId row = build.At(build.Ref(shader.view), 1u);
  const ExprId component = build.Swizzled(row, {2});
  EXPECT_EQ(WholeOf(shader, component), row);
  EXPECT_EQ(RootOf(shader, component), shader.view);
  EXPECT_EQ(RootOf(shader, Twice(Scale())), VarId{});
  EXPECT_EQ(RootOf(shader, build.Swizzled(build.ZeroOf(build.TypeOf(row)), {0})), VarId{});
  EXPECT_TRUE(HasLiteralIndices(shader, component));
  const ExprId number =
      build.Ref(shader.AddVar("i", shader.types.Make(Scalar::kInt), Storage::kIn));
  EXPECT_FALSE(
      HasLiteralIndices(shader, build.Swizzled(build.At(build.Ref(shader.view), number), {2})));
}

TEST_F(Access, WritesAreTargetsOfTheNodeItself) {
  const ExprId target = Counter();
  EXPECT_THAT(Writes(build.AssignTo(target, Increment(Scale()))), ElementsAre(target));
  EXPECT_THAT(Writes(Increment(target)), ElementsAre(target));
  EXPECT_THAT(Writes(Twice(Increment(target))), IsEmpty());
  EXPECT_THAT(Writes(Intrinsic2(Intrinsic::kModf, Scale(), target)), ElementsAre(target));
  EXPECT_THAT(Writes(Intrinsic2(Intrinsic::kMax, Scale(), target)), IsEmpty());
  EXPECT_THAT(Writes(build.CallOf(Function(Storage::kInOut, {}), std::span(&target, 1))),
              ElementsAre(target));
  EXPECT_THAT(Writes(build.CallOf(Function(Storage::kIn, {}), std::span(&target, 1))), IsEmpty());
}

TEST_F(Access, PureExpressionsChangeNothing) {
  EXPECT_TRUE(IsPure(shader, Twice(Scale())));
  EXPECT_TRUE(IsPure(shader, build.UnaryOf(UnaryOp::kNegate, Scale())));
  EXPECT_FALSE(IsPure(shader, Twice(Increment(Counter()))));
  EXPECT_FALSE(IsPure(shader, Twice(build.AssignTo(Counter(), build.Float(1)))));
  EXPECT_TRUE(IsPure(shader, Intrinsic2(Intrinsic::kMax, Scale(), Scale())));
  EXPECT_FALSE(IsPure(shader, Twice(Intrinsic2(Intrinsic::kModf, Scale(), Counter()))));
  const ExprId argument = build.Ref(shader.parameter);
  EXPECT_FALSE(IsPure(shader, build.CallOf(shader.entry, std::span(&argument, 1))));
}

TEST_F(Access, EffectsLookIntoFunctions) {
  const auto call = [&](FunctionId function, ExprId argument) {
    return build.CallOf(function, std::span(&argument, 1));
  };
  const FunctionId reads = Function(Storage::kIn, {build.Eval(Twice(Counter()))});
  const FunctionId writes = Function(Storage::kIn, {build.Eval(Increment(Counter()))});
  const FunctionId calls = Function(Storage::kIn, {build.Eval(call(writes, Scale()))});
  const FunctionId own = Function(Storage::kIn, {});
  shader.functions[own].body = build.BlockOf(
      std::array{build.Eval(Increment(build.Ref(shader.functions[own].parameters[0])))});
  const FunctionId out = Function(Storage::kOut, {});
  Effects effects(shader);
  EXPECT_TRUE(effects.MayBeSkipped(call(reads, Scale())));
  EXPECT_TRUE(effects.MayBeSkipped(call(own, Scale())));
  EXPECT_FALSE(effects.MayBeSkipped(call(writes, Scale())));
  EXPECT_FALSE(effects.MayBeSkipped(call(calls, Scale())));
  EXPECT_FALSE(effects.MayBeSkipped(call(out, Counter())));
}

TEST_F(Access, StatementsThatMayAssign) {
  const StmtId in_a_branch =
      build.Stmt(If{build.Bool(true), build.Eval(build.AssignTo(Counter(), build.Float(1))), {}});
  const auto assigns = [&](StmtId stmt, VarId var) -> bool {
    return AssignedIn(shader, {&stmt, 1})[var.index];
  };
  EXPECT_TRUE(assigns(in_a_branch, shader.counter));
  EXPECT_FALSE(assigns(in_a_branch, shader.scale));
  EXPECT_FALSE(assigns(build.Eval(Twice(Counter())), shader.counter));
}

TEST_F(Access, MainCallsTheEntry) {
  ASSERT_EQ(MainBody(shader).size(), 1u);
  const StmtId statement = MainBody(shader)[0];
  const Assign* assign = AsAssignment(shader, statement);
  ASSERT_TRUE(assign);
  EXPECT_EQ(EntryCall(shader, statement), assign->value);
  const StmtId other = build.Eval(build.AssignTo(Counter(), Scale(), BinaryOp::kAdd));
  EXPECT_EQ(AsAssignment(shader, other), nullptr);
  EXPECT_EQ(EntryCall(shader, other), ExprId{});
  SetMainBody(shader, std::vector<StmtId>{other, statement});
  EXPECT_THAT(MainBody(shader), ElementsAre(other, statement));
}

}  // namespace
}  // namespace clipc::ir
