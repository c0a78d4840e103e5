// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/legalize.h"

#include <vector>

#include <gtest/gtest.h>

#include "ir/evaluate.h"
#include "ir/intrinsic_list.h"
#include "legalize/test_shader.h"

// The reference evaluator runs the program before and after the legalising passes: its outputs have
// the same bits.
namespace clipc::legalize {
namespace {

using namespace ir;

class LegalizeTest : public ::testing::Test {
 protected:
  // A local variable with these components.
  ExprId Value(TypeId type, const std::vector<double>& components) {
    Builder b = shader_.Make();
    std::vector<ExprId> literals;
    const Scalar kind = shader_.program.types[type].scalar;
    for (const double component : components) literals.push_back(b.LiteralOf(kind, component));
    const VarId local = b.Local("local", type);
    shader_.Add(
        b.Stmt(Declare{local, literals.size() == 1 ? literals[0] : b.ConstructOf(type, literals)}));
    return b.Ref(local);
  }
  TypeId Matrix(Scalar kind) { return shader_.program.types.Matrix(kind, 2, 3); }

  void ExpectSame() {
    shader_.Finish();
    const EvalResult before = RunMain(shader_.program, {});
    ASSERT_TRUE(before) << before.error;
    constexpr Needs kOfNoMix{.integer_choices = true, .bit_functions = true, .flat_arrays = true};
    constexpr Needs kOfNoUint{.signed_integers = true,
                              .float_choices = true,
                              .integer_choices = true,
                              .rounding = true,
                              .bit_functions = true,
                              .flat_arrays = true};
    constexpr Needs kOfSquares{.signed_integers = true,
                               .square_matrices = true,
                               .constant_loops = true,
                               .constant_indices = true,
                               .float_choices = true,
                               .integer_choices = true,
                               .struct_choices = true,
                               .rounding = true,
                               .bit_functions = true,
                               .flat_arrays = true};
    constexpr Needs kOfSpirv{.array_choices = true, .simple_operands = true};
    for (const Needs& needs : {Needs{}, kOfNoMix, kOfNoUint, kOfSquares, kOfSpirv}) {
      Program program = shader_.program;
      program.form = Form::kInlined;
      ASSERT_TRUE(Legalize(program, needs));
      EXPECT_EQ(Verify(program, Form::kAddressed), std::nullopt);
      const EvalResult after = RunMain(program, {});
      ASSERT_TRUE(after) << after.error;
      EXPECT_EQ(before.outputs.values, after.outputs.values);
    }
    EXPECT_NE(Verify(shader_.program, Form::kLegalized), std::nullopt);
  }

  TestShader shader_;
};

TEST_F(LegalizeTest, MatricesOfFloats) {
  Builder b = shader_.Make();
  const TypeId type = Matrix(Scalar::kFloat), bools = Matrix(Scalar::kBool);
  const auto m = [&] { return Value(type, {1, -2, 3.5, 0.25, 5, -6}); };
  const auto n = [&] { return Value(type, {-1, 7, 2, 0.5, 3, 4}); };
  shader_.Use(b.IntrinsicOf(Intrinsic::kMax, type, {m(), n()}));
  shader_.Use(b.BinaryOf(BinaryOp::kMod, m(), n()));
  shader_.Use(b.Add(type, Select{b.BinaryOf(BinaryOp::kLess, m(), n()), m(), n()}));
  shader_.Use(b.ConvertTo(Scalar::kInt, m()));
  shader_.Use(b.ConvertTo(Scalar::kFloat,
                          b.IntrinsicOf(Intrinsic::kAny, shader_.program.types.Make(Scalar::kBool),
                                        {b.BinaryOf(BinaryOp::kGreater, m(), n())})));
  shader_.Use(b.ConvertTo(
      Scalar::kFloat,
      b.BinaryOf(BinaryOp::kLogicalAnd, b.ConvertTo(Scalar::kBool, m()), b.ZeroOf(bools))));
  const ExprId target = m();
  shader_.Use(b.AssignTo(target, n(), BinaryOp::kMul));
  const ExprId whole = m();
  shader_.Use(b.IntrinsicOf(Intrinsic::kModf, type, {n(), whole}));
  ExpectSame();
}

TEST_F(LegalizeTest, MatricesOfIntegers) {
  Builder b = shader_.Make();
  TypeTable& types = shader_.program.types;
  const TypeId type = Matrix(Scalar::kInt);
  const auto i = [&] { return Value(type, {1, -2, 3, 4, 5, -6}); };
  const auto transposed = [&] {
    return b.IntrinsicOf(Intrinsic::kTranspose, types.Matrix(Scalar::kInt, 3, 2), {i()});
  };
  shader_.Use(b.UnaryOf(UnaryOp::kNegate, i()));
  const ExprId stepped = i();
  shader_.Use(b.UnaryOf(UnaryOp::kPostIncrement, stepped));
  shader_.Use(
      b.IntrinsicOf(Intrinsic::kMul, types.Matrix(Scalar::kInt, 2, 2), {i(), transposed()}));
  shader_.Use(b.IntrinsicOf(Intrinsic::kMul, types.Vector(Scalar::kInt, 2),
                            {i(), Value(types.Vector(Scalar::kInt, 3), {2, 3, 4})}));
  shader_.Use(b.IntrinsicOf(Intrinsic::kMul, types.Vector(Scalar::kInt, 3),
                            {Value(types.Vector(Scalar::kInt, 2), {2, 3}), i()}));
  shader_.Use(b.Add(types.Matrix(Scalar::kInt, 2, 2), MatrixTruncate{i()}));
  ExpectSame();
}

TEST_F(LegalizeTest, Arithmetic) {
  Builder b = shader_.Make();
  TypeTable& types = shader_.program.types;
  const TypeId ints = types.Vector(Scalar::kInt, 3), uints = types.Vector(Scalar::kUint, 3);
  const TypeId floats = types.Vector(Scalar::kFloat, 3);
  const auto i = [&] { return Value(ints, {7, -7, 40}); };
  const auto f = [&] { return Value(floats, {0.5, -3, 8}); };
  shader_.Use(b.BinaryOf(BinaryOp::kMod, i(), Value(ints, {3, 4, -9})));
  shader_.Use(b.BinaryOf(BinaryOp::kShiftLeft, i(), Value(ints, {1, 33, 31})));
  shader_.Use(b.BinaryOf(BinaryOp::kShiftRight, i(), b.SplatTo(ints, b.Int(34))));
  shader_.Use(b.IntrinsicOf(Intrinsic::kSign, ints, {Value(uints, {0, 3, 4})}));
  shader_.Use(b.IntrinsicOf(Intrinsic::kDot, types.Make(Scalar::kInt), {i(), i()}));
  shader_.Use(b.IntrinsicOf(Intrinsic::kMad, floats, {f(), f(), f()}));
  shader_.Use(b.IntrinsicOf(Intrinsic::kRcp, floats, {f()}));
  shader_.Use(b.IntrinsicOf(Intrinsic::kFmod, floats, {f(), Value(floats, {2, 2, -3})}));
  const ExprId sine = f(), cosine = f();
  shader_.Add(b.Eval(b.IntrinsicOf(Intrinsic::kSincos, types.Void(), {f(), sine, cosine})));
  const ExprId exponent = f();
  shader_.Use(b.IntrinsicOf(Intrinsic::kFrexp, floats, {f(), exponent}));
  ExpectSame();
}

TEST_F(LegalizeTest, BothSidesOfLogicalOperators) {
  Builder b = shader_.Make();
  const TypeId type = shader_.program.types.Make(Scalar::kBool);
  const VarId changed = b.Local("changed", type);
  shader_.Add(b.Stmt(Declare{changed, b.Bool(false)}));
  const ExprId both =
      b.BinaryOf(BinaryOp::kLogicalAnd, Value(type, {0}), b.AssignTo(b.Ref(changed), b.Bool(true)));
  shader_.Use(b.ConvertTo(Scalar::kFloat, both));
  shader_.Use(b.ConvertTo(Scalar::kFloat, b.Ref(changed)));
  ExpectSame();
}

}  // namespace
}  // namespace clipc::legalize
