// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/builder.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "ir/access.h"
#include "ir/intrinsic_list.h"
#include "ir/print.h"
#include "ir/test_program.h"
#include "ir/verify.h"

namespace clipc::ir {
namespace {

class BuilderTest : public testing::Test {
 protected:
  std::string TypeName(ExprId expr) { return shader.types.Name(build.TypeOf(expr)); }
  std::string Text(ExprId expr) { return PrintExpr(shader, expr); }

  TestProgram shader;
  Builder& build = shader.build;
};

TEST_F(BuilderTest, TypesFollowFromTheNodes) {
  EXPECT_EQ(TypeName(build.At(build.Ref(shader.planes), 1u)), "float4");
  EXPECT_EQ(TypeName(build.At(build.Ref(shader.view), 1u)), "float4");
  EXPECT_EQ(TypeName(build.At(build.Ref(shader.parameter), 1u)), "float");
  EXPECT_EQ(TypeName(build.Swizzled(build.Ref(shader.parameter), {1, 1, 0})), "float3");
  EXPECT_EQ(TypeName(build.Swizzled(build.Ref(shader.parameter), {1})), "float");
  EXPECT_EQ(TypeName(build.BinaryOf(BinaryOp::kLess, build.Ref(shader.parameter),
                                    build.Ref(shader.parameter))),
            "bool4");
  EXPECT_EQ(TypeName(build.BinaryOf(BinaryOp::kShiftLeft, build.Uint(1), build.Int(1))), "uint");
  EXPECT_EQ(TypeName(build.ConvertTo(Scalar::kInt, build.Ref(shader.view))), "int4x4");
  EXPECT_EQ(TypeName(build.CommaOf(build.Float(1), build.Int(1))), "int");
  EXPECT_EQ(TypeName(build.AssignTo(build.Ref(shader.parameter),
                                    build.ZeroOf(shader.types.Vector(Scalar::kFloat, 4)))),
            "float4");
}

TEST_F(BuilderTest, NothingIsAddedWhereNothingChanges) {
  const ExprId one = build.Float(1);
  EXPECT_EQ(build.ConvertTo(Scalar::kFloat, one), one);
  EXPECT_NE(build.ConvertTo(Scalar::kHalf, one), one);
  EXPECT_EQ(build.SplatTo(shader.types.Make(Scalar::kFloat), one), one);
}

TEST_F(BuilderTest, LiteralsAreConverted) {
  EXPECT_EQ(Text(build.LiteralOf(Scalar::kInt, -2.9)), "-2");
  EXPECT_EQ(Text(build.LiteralOf(Scalar::kBool, 0.5)), "true");
  EXPECT_EQ(Text(build.LiteralOf(Scalar::kFloat, 0.1)), "0.1");
  EXPECT_EQ(Text(build.LiteralOf(Scalar::kUint, -1)), "0u");
}

TEST_F(BuilderTest, CloneSharesNothing) {
  const ExprId call = build.IntrinsicOf(
      Intrinsic::kDot, shader.types.Make(Scalar::kFloat),
      {build.Ref(shader.parameter),
       build.ConstructOf(
           shader.types.Vector(Scalar::kFloat, 4),
           {build.Swizzled(build.Ref(shader.parameter), {0, 1, 2}), build.Float(1)})});
  const ExprId clone = Clone(shader, call);
  EXPECT_EQ(Text(clone), "dot(p, float4(p.xyz, 1.0))");
  shader.Append({build.Eval(call), build.Eval(clone)});
  EXPECT_EQ(Verify(shader, Form::kTyped), std::nullopt);
}

TEST_F(BuilderTest, AppendToBodyKeepsTheOrder) {
  shader.Append({build.Eval(build.Int(1))});
  shader.Append({build.Eval(build.Int(2)), build.Eval(build.Int(3))});
  const std::string text = Print(shader);
  EXPECT_NE(text.find("  1\n  2\n  3\n}"), std::string::npos) << text;
}

// A list read from the program's own pool may be passed back to the builder, though the pool grows
// meanwhile.
TEST_F(BuilderTest, ListsOfThePoolMayBePassedBack) {
  const TypeId array = shader.types.Array(shader.types.Make(Scalar::kInt), 2);
  ExprId construct = build.ConstructOf(array, {build.Int(4), build.Int(5)});
  for (int i = 0; i < 100; ++i) {
    const List<ExprId> list = std::get<Construct>(shader.exprs[construct].node).arguments;
    construct = build.ConstructOf(array, std::as_const(shader).expr_lists[list]);
  }
  EXPECT_EQ(Text(construct), "int[2]{4, 5}");
}

// The parser stops at a nesting of some thousands; every recursion over the tree must stand that.
TEST_F(BuilderTest, DeepTrees) {
  constexpr int kDepth = 3000;
  ExprId deep = build.Ref(shader.parameter);
  for (int i = 0; i < kDepth; ++i) deep = build.UnaryOf(UnaryOp::kNegate, deep);
  StmtId nested = shader.Return(deep);
  for (int i = 0; i < kDepth; ++i) nested = build.BlockOf(std::vector<StmtId>{nested});
  shader.Append({build.Eval(Clone(shader, deep)), nested});
  EXPECT_TRUE(IsPure(shader, deep));
  EXPECT_EQ(Verify(shader, Form::kTyped), std::nullopt);
  EXPECT_FALSE(Print(shader).empty());
  EXPECT_EQ(shader.Run({1, 2, 3, 4})[3], 4);
}

}  // namespace
}  // namespace clipc::ir
