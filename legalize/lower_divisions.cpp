// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "ir/evaluate.h"
#include "ir/scalar.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// What a helper function treats as special: divisors that are 0, and those that are -1.
struct Special {
  bool zero = false, minus_one = false;
  bool computes_both = false;  // whether a choice between scalars may compute what it drops
};

// The body of `divide(x, y)` or `modulo(x, y)`, for scalars or vectors.
class DivisionBody {
 public:
  DivisionBody(const Program& program, HelperBody& body, TypeId type, bool divides)
      : body_(body),
        type_(type),
        kind_(program.types[type].scalar),
        is_scalar_(program.types[type].kind == TypeKind::kScalar),
        divides_(divides) {}

  void Write(BinaryOp op, Special special) {
    Builder& b = body_.b;
    ExprId divisor = body_[1];
    const bool computes_both = special.computes_both || !is_scalar_;
    if (special.zero && computes_both) divisor = Choose(Is(0), Number(1), divisor);
    // The remainder by 1 is that by -1.
    if (special.minus_one && (computes_both || !divides_))
      divisor = Choose(Is(-1), Number(1), divisor);
    ExprId result = b.BinaryOf(op, body_[0], divisor);
    if (special.minus_one && divides_)
      result = Choose(Is(-1), b.UnaryOf(UnaryOp::kNegate, body_[0]), result);
    if (special.zero) result = Choose(Is(0), OfZero(), result);
    body_.Return(result);
  }

 private:
  ExprId Number(int value) { return body_.b.SplatTo(type_, body_.b.LiteralOf(kind_, value)); }
  ExprId Is(int value) { return body_.b.BinaryOf(BinaryOp::kEqual, body_[1], Number(value)); }
  ExprId Choose(ExprId condition, ExprId when_true, ExprId when_false) {
    return is_scalar_ ? body_.b.Add(type_, Conditional{condition, when_true, when_false})
                      : body_.b.Add(type_, Select{condition, when_true, when_false});
  }
  // Direct3D's quotient by 0 and the remainder: all bits, with the sign of the dividend.
  ExprId OfZero() {
    Builder& b = body_.b;
    if (IsUnsigned(kind_)) return b.UnaryOf(UnaryOp::kComplement, Number(0));
    return Choose(b.BinaryOf(BinaryOp::kLess, body_[0], Number(0)), Number(1), Number(-1));
  }

  HelperBody& body_;
  TypeId type_;
  Scalar kind_;
  bool is_scalar_, divides_;
};

// Makes `expr` a call of a function that divides by no special divisor.
void BecomeSafe(Legalizer& legalizer, ExprId expr, const Binary& node) {
  const TypeId type = legalizer.program.exprs[expr].type;
  const Parameter parameters[] = {{"x", type}, {"y", type}};
  const ExprId arguments[] = {node.left, node.right};
  const bool divides = node.op == BinaryOp::kDiv;
  // Mesa's compiler computes both sides of a choice between constants.
  const Special special{.zero = legalizer.GuardsDivisions(),
                        .minus_one = !IsUnsigned(legalizer.TypeOf(expr).scalar),
                        .computes_both = legalizer.NamesLeastInteger()};
  legalizer.BecomeCall(
      expr, divides ? "divide" : "modulo", parameters, arguments, [&](HelperBody& body) {
        DivisionBody(legalizer.program, body, type, divides).Write(node.op, special);
      });
}

// Rewrites a division of integers whose divisor may be 0 or -1.
void Lower(Legalizer& legalizer, ExprId expr, const Binary& node) {
  const Program& program = legalizer.program;
  const TypeId type = program.exprs[expr].type;
  const Scalar kind = program.types[type].scalar;
  if (legalizer.MayDivideByZero(node.right)) return BecomeSafe(legalizer, expr, node);
  if (IsUnsigned(kind)) return;
  // Whether the dividend may be a constant that has no opposite.
  const bool may_be_least = legalizer.NamesLeastInteger();
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
    if (expr.index >= old) return;  // in a function that divides by no special divisor
    const auto* binary = As<Binary>(legalizer.program, expr);
    if (!binary || (binary->op != BinaryOp::kDiv && binary->op != BinaryOp::kMod)) return;
    if (!legalizer.IsNumeric(expr) || IsFloat(legalizer.TypeOf(expr).scalar)) return;
    Lower(legalizer, expr, Binary(*binary));
  });
}

}  // namespace clipc::legalize
