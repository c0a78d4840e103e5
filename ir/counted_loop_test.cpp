// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/counted_loop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ir/test_program.h"

namespace clipc::ir {
namespace {

class CountedLoopTest : public ::testing::Test {
 protected:
  ExprId Compare(BinaryOp op, ExprId left, ExprId right) { return b.BinaryOf(op, left, right); }
  ExprId IsLess(VarId var) { return Compare(BinaryOp::kLess, b.Ref(var), b.Int(8)); }
  ExprId Step(UnaryOp op, VarId var) { return b.UnaryOf(op, b.Ref(var)); }
  For Loop(std::vector<StmtId> init, ExprId condition, ExprId step, std::vector<StmtId> body = {}) {
    return {program.Stmts(std::move(init)), condition, step, b.BlockOf(body)};
  }

  TestProgram program;
  Builder& b = program.build;
  VarId i = b.Local("i", program.types.Make(Scalar::kInt));
  VarId j = b.Local("j", program.types.Make(Scalar::kInt));
};

// for (int i = 0; i < 8; ++i)
TEST_F(CountedLoopTest, HasAllParts) {
  const ExprId start = b.Int(0), condition = IsLess(i), step = Step(UnaryOp::kPreIncrement, i);
  const CountedLoop parts = PartsOf(program, Loop({program.DeclareVar(i, start)}, condition, step));
  EXPECT_EQ(parts.counter, i);
  EXPECT_TRUE(parts.is_declared);
  EXPECT_EQ(parts.start, start);
  EXPECT_EQ(parts.comparison, condition);
  EXPECT_FALSE(parts.more);
  EXPECT_EQ(parts.step, step);
  EXPECT_FALSE(parts.step_size);
  EXPECT_FALSE(parts.is_down);
}

// for (i = 0; true && i < 8; i -= 2)
TEST_F(CountedLoopTest, MayAssignAndHaveAFurtherCondition) {
  const ExprId start = b.Int(0), compare = IsLess(i), more = b.Bool(true), size = b.Int(2);
  const ExprId condition = b.BinaryOf(BinaryOp::kShortCircuitAnd, more, compare);
  const ExprId step = b.AssignTo(b.Ref(i), size, BinaryOp::kSub);
  const CountedLoop parts =
      PartsOf(program, Loop({b.Eval(b.AssignTo(b.Ref(i), start))}, condition, step));
  EXPECT_EQ(parts.counter, i);
  EXPECT_FALSE(parts.is_declared);
  EXPECT_EQ(parts.start, start);
  EXPECT_EQ(parts.comparison, compare);
  EXPECT_EQ(parts.more, more);
  EXPECT_EQ(parts.step, step);
  EXPECT_EQ(parts.step_size, size);
  EXPECT_TRUE(parts.is_down);
}

// for (int i = 0, j = 0; j < 8; j--)
TEST_F(CountedLoopTest, CounterIsTheVariableThatTheConditionCompares) {
  const ExprId step = Step(UnaryOp::kPostDecrement, j);
  const For loop =
      Loop({program.DeclareVar(i, b.Int(0)), program.DeclareVar(j, b.Int(0))}, IsLess(j), step);
  EXPECT_EQ(PartsOf(program, loop).counter, j);
  EXPECT_EQ(PartsOf(program, loop).step, step);
  EXPECT_TRUE(PartsOf(program, loop).is_down);
}

// for (int i = 0; (uint)i < 8; ++i)
TEST_F(CountedLoopTest, ComparesTheCounterAsAnotherKindOfInteger) {
  const auto compares = [&](Scalar kind) {
    const ExprId condition =
        Compare(BinaryOp::kLess, b.ConvertTo(kind, b.Ref(i)), b.LiteralOf(kind, 8));
    const For loop = Loop({program.DeclareVar(i, b.Int(0))}, condition, {});
    return static_cast<bool>(PartsOf(program, loop).comparison);
  };
  EXPECT_TRUE(compares(Scalar::kUint));
  EXPECT_FALSE(compares(Scalar::kFloat));
}

// for (int i = 0; 8 > i; i = 1)
TEST_F(CountedLoopTest, LacksThePartsOfAnotherForm) {
  const ExprId condition = Compare(BinaryOp::kGreater, b.Int(8), b.Ref(i));
  const For loop =
      Loop({program.DeclareVar(i, b.Int(0))}, condition, b.AssignTo(b.Ref(i), b.Int(1)));
  const CountedLoop parts = PartsOf(program, loop);
  EXPECT_EQ(parts.counter, i);
  EXPECT_FALSE(parts.comparison);
  EXPECT_FALSE(parts.step);
}

// for (int i = 0, ++j; i < 8; ++j)
TEST_F(CountedLoopTest, HasNoCounterWhereTheHeadDoesSomethingElse) {
  const For loop = Loop({program.DeclareVar(i, b.Int(0)), b.Eval(Step(UnaryOp::kPreIncrement, j))},
                        IsLess(i), Step(UnaryOp::kPreIncrement, j));
  EXPECT_FALSE(PartsOf(program, loop).counter);
  EXPECT_FALSE(PartsOf(program, Loop({}, IsLess(i), {})).counter);
}

// for (..) { j = 1; }
TEST_F(CountedLoopTest, BodyMayChangeTheCounter) {
  const For loop = Loop({}, {}, {}, {b.Eval(b.AssignTo(b.Ref(j), b.Int(1)))});
  EXPECT_TRUE(IsChangedInBody(program, loop, j));
  EXPECT_FALSE(IsChangedInBody(program, loop, i));
}

}  // namespace
}  // namespace clipc::ir
