// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "backend-glsl/legalize/legalize.h"
#include "ir/evaluate.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// Makes `expr` a call of a function that divides by 1 where `y` is -1.
void BecomeSafe(Legalizer& legalizer, ExprId expr, const Binary& node) {
  const TypeId type = legalizer.program.exprs[expr].type;
  const Parameter parameters[] = {{"x", type}, {"y", type}};
  const ExprId arguments[] = {node.left, node.right};
  const bool divides = node.op == BinaryOp::kDiv;
  legalizer.BecomeCall(
      expr, divides ? "divide" : "modulo", parameters, arguments, [&](HelperBody& body) {
        const bool is_scalar = legalizer.program.types[type].kind == TypeKind::kScalar;
        const Scalar kind = legalizer.program.types[type].scalar;
        const auto number = [&](int value) {
          return body.b.SplatTo(type, body.b.LiteralOf(kind, value));
        };
        const auto choose = [&](ExprId when_true, ExprId when_false) {
          const ExprId is_minus_one = body.b.BinaryOf(BinaryOp::kEqual, body[1], number(-1));
          return is_scalar ? body.b.Add(type, Conditional{is_minus_one, when_true, when_false})
                           : body.b.Add(type, Select{is_minus_one, when_true, when_false});
        };
        const ExprId result = body.b.BinaryOf(node.op, body[0], choose(number(1), body[1]));
        if (!divides) return body.Return(result);
        body.Return(choose(body.b.UnaryOf(UnaryOp::kNegate, body[0]), result));
      });
}

// Rewrites a division of signed integers whose divisor may be -1. `may_be_least`: whether the
// dividend may be a constant that has no opposite.
void Lower(Legalizer& legalizer, ExprId expr, const Binary& node, bool may_be_least) {
  const Program& program = legalizer.program;
  const TypeId type = program.exprs[expr].type;
  const Scalar kind = program.types[type].scalar;
  Builder b = legalizer.At(expr);
  const auto divisor = ConstantBits(program, node.right);
  const auto is_minus_one = [&](std::uint64_t bits) { return NumberOf(bits, kind) == -1; };
  if (divisor && std::ranges::none_of(*divisor, is_minus_one)) return;
  if (may_be_least && ConstantBits(program, expr)) {
    legalizer.Become(expr, b.ValueOf(type, *ConstantBits(program, expr)));
  } else if (divisor && std::ranges::all_of(*divisor, is_minus_one)) {
    const ExprId one = b.SplatTo(type, b.LiteralOf(kind, 1));
    legalizer.Become(expr, node.op == BinaryOp::kDiv ? b.UnaryOf(UnaryOp::kNegate, node.left)
                                                     : b.BinaryOf(node.op, node.left, one));
  } else if (may_be_least || divisor) {
    BecomeSafe(legalizer, expr, node);
  }
}

}  // namespace

void LowerDivisions(Legalizer& legalizer) {
  const std::uint32_t old = legalizer.program.exprs.size();
  legalizer.ForEach([&](ExprId expr) {
    if (expr.index >= old) return;  // in a function that divides by no -1
    const Program& program = legalizer.program;
    const auto* binary = As<Binary>(program, expr);
    if (!binary || (binary->op != BinaryOp::kDiv && binary->op != BinaryOp::kMod)) return;
    const Scalar kind = legalizer.TypeOf(expr).scalar;
    if (!legalizer.IsNumeric(expr) || IsFloat(kind) || IsUnsigned(kind)) return;
    Lower(legalizer, expr, Binary(*binary), legalizer.NamesLeastInteger());
  });
}

}  // namespace clipc::glsl
