// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/check_values.h"

#include <algorithm>
#include <cmath>

#include "ir/access.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

// Whether holds(number) is true for a component of the expression that is a literal. A constant is
// looked into where `follows` is set, and no other constant in its value.
template <typename Holds>
bool AnyLiteral(const Program& program, ExprId expr, const Holds& holds, bool follows = true) {
  const auto any = [&](ExprId part) { return AnyLiteral(program, part, holds, follows); };
  return Visit(Overloaded{
                   [&](const Literal& literal) {
                     return holds(NumberOf(literal.bits, TypeOf(program, expr).scalar));
                   },
                   [&](const Zero&) { return holds(0.0); },
                   [&](const OneOf<Splat, Convert> auto& node) { return any(node.operand); },
                   [&](const Construct& node) {
                     return std::ranges::any_of(program.expr_lists[node.arguments], any);
                   },
                   [&](const VarRef& node) {
                     const Var& var = program.vars[node.var];
                     return follows && var.storage == Storage::kConstant && var.init &&
                            AnyLiteral(program, var.init, holds, false);
                   },
                   [](const auto&) { return false; },
               },
               program.exprs[expr].node);
}

bool IsZero(double number) { return number == 0; }

// Whether fxc multiplies in place of a call of pow, which works for negative numbers too.
bool IsWholeExponent(const Program& program, ExprId exponent) {
  const auto is_whole = [](double number) { return number == std::trunc(number); };
  return AnyLiteral(program, exponent, is_whole);
}

// Whether both are paths into one variable: `x * x` is not a product of independent signs.
bool HaveOneRoot(const Program& program, ExprId left, ExprId right) {
  const VarId root = RootOf(program, left);
  return root && root == RootOf(program, right);
}

}  // namespace

void ValueCheck::CheckDivision(BinaryOp op, ExprId divisor) {
  const bool is_float = IsFloat(TypeOf(program_, divisor).scalar);
  // A float divided by 0 is infinity, which is what some shaders want; dxc has no word about it.
  if (is_float && (op == BinaryOp::kMod || program_.profile.IsAtLeast(6, 0))) return;
  if (!AnyLiteral(program_, divisor, IsZero)) return;
  const Span span = program_.exprs[divisor].span;
  if (is_float) {
    diagnostics_.Report(span, diag::DivisionByZero);
  } else {
    diagnostics_.Report(span, diag::IntegerDivisionByZero);
  }
}

void ValueCheck::CheckPow(const IntrinsicCall& call) {
  if (program_.profile.IsAtLeast(6, 0)) return;
  const auto arguments = program_.expr_lists[call.arguments];
  const ExprId base = arguments[0], exponent = arguments[1];
  steps_ = 0;
  if (IsWholeExponent(program_, exponent) || SignOf(base) != Sign::kMayBeNegative) return;
  diagnostics_.Report(program_.exprs[base].span, diag::PowOfNegative);
}

ValueCheck::Sign ValueCheck::SignOf(ExprId expr) {
  constexpr int kMostSteps = 256;  // a variable may be looked into at each of its uses
  if (++steps_ > kMostSteps) return Sign::kUnknown;
  const Scalar scalar = TypeOf(program_, expr).scalar;
  if (IsUnsigned(scalar) || scalar == Scalar::kBool) return Sign::kNotNegative;
  const auto of = [&](ExprId part) { return SignOf(part); };
  return Visit(
      Overloaded{
          [&](const Literal& literal) {
            return NumberOf(literal.bits, scalar) < 0 ? Sign::kMayBeNegative : Sign::kNotNegative;
          },
          [](const Zero&) { return Sign::kNotNegative; },
          [&](const OneOf<Splat, Convert> auto& node) { return of(node.operand); },
          [&](const Unary& node) {
            if (node.op != UnaryOp::kNegate) return Sign::kUnknown;
            return of(node.operand) == Sign::kUnknown ? Sign::kUnknown : Sign::kMayBeNegative;
          },
          [&](const Binary& node) { return SignOfBinary(node); },
          [&](const IntrinsicCall& call) { return SignOfCall(call); },
          [&](const Conditional& node) {
            const bool neither = of(node.when_true) == Sign::kNotNegative &&
                                 of(node.when_false) == Sign::kNotNegative;
            return neither ? Sign::kNotNegative : Sign::kUnknown;
          },
          [&](const Construct& node) {
            Sign sign = Sign::kNotNegative;
            for (const ExprId part : program_.expr_lists[node.arguments])
              sign = std::max(sign, of(part));
            return sign;
          },
          [&](const OneOf<VarRef, FieldRef, Index, Swizzle, MatrixSwizzle> auto&) {
            if (const VarId root = RootOf(program_, expr)) return SignOfVar(root);
            // One component of `float2(-1, x)` is not as the whole.
            const Sign whole = of(WholeOf(program_, expr));
            const bool is_mixed =
                whole == Sign::kMayBeNegative && As<Construct>(program_, WholeOf(program_, expr));
            return is_mixed ? Sign::kUnknown : whole;
          },
          [](const auto&) { return Sign::kUnknown; },
      },
      program_.exprs[expr].node);
}

ValueCheck::Sign ValueCheck::SignOfVar(VarId id) {
  const Var& var = program_.vars[id];
  if (var.storage == Storage::kUniform) return Sign::kMayBeNegative;
  if (var.storage == Storage::kConstant) return var.init ? SignOf(var.init) : Sign::kUnknown;
  if (var.storage != Storage::kLocal && var.storage != Storage::kIn) return Sign::kUnknown;
  FindValues();
  if (is_assigned_[id.index]) return Sign::kUnknown;
  if (var.storage == Storage::kLocal)
    return declared_[id.index] ? SignOf(declared_[id.index]) : Sign::kUnknown;
  // What a function of the shader's is called with is not looked up.
  const std::vector<VarId>& inputs = program_.functions[program_.entry].parameters;
  return std::ranges::find(inputs, id) != inputs.end() ? Sign::kMayBeNegative : Sign::kUnknown;
}

ValueCheck::Sign ValueCheck::SignOfBinary(const Binary& node) {
  const Sign left = SignOf(node.left), right = SignOf(node.right);
  const Sign both = std::max(left, right);
  switch (node.op) {
    case BinaryOp::kAdd:
    case BinaryOp::kDiv: return both;
    case BinaryOp::kMul:
      return HaveOneRoot(program_, node.left, node.right) ? Sign::kUnknown : both;
    // fxc knows the ranges of some values: 1 - saturate(x) is not negative.
    case BinaryOp::kSub: return both == Sign::kNotNegative ? Sign::kUnknown : both;
    default: return Sign::kUnknown;
  }
}

ValueCheck::Sign ValueCheck::SignOfCall(const IntrinsicCall& call) {
  const auto arguments = program_.expr_lists[call.arguments];
  const auto of = [&](std::size_t i) { return SignOf(arguments[i]); };
  switch (call.op) {
    case Intrinsic::kAbs:
    case Intrinsic::kDistance:
    case Intrinsic::kExp:
    case Intrinsic::kExp2:
    case Intrinsic::kFrac:
    case Intrinsic::kLength:
    case Intrinsic::kPow:
    case Intrinsic::kRsqrt:
    case Intrinsic::kSaturate:
    case Intrinsic::kSmoothstep:
    case Intrinsic::kSqrt:
    case Intrinsic::kStep: return Sign::kNotNegative;
    case Intrinsic::kMax: {
      const Sign first = of(0), second = of(1);
      const bool neither = std::min(first, second) == Sign::kNotNegative;
      return neither ? Sign::kNotNegative : std::max(first, second);
    }
    case Intrinsic::kWholePower: {
      const auto is_even = [](double number) { return std::fmod(number, 2) == 0; };
      return AnyLiteral(program_, arguments[1], is_even) ? Sign::kNotNegative : of(0);
    }
    case Intrinsic::kMin: return std::max(of(0), of(1));
    case Intrinsic::kClamp:
      return of(1) == Sign::kNotNegative ? Sign::kNotNegative : Sign::kUnknown;
    case Intrinsic::kDot:
      return HaveOneRoot(program_, arguments[0], arguments[1]) ? Sign::kUnknown
                                                               : Sign::kMayBeNegative;
    case Intrinsic::kCos:
    case Intrinsic::kCross:
    case Intrinsic::kMul:
    case Intrinsic::kNormalize:
    case Intrinsic::kReflect:
    case Intrinsic::kSin: return Sign::kMayBeNegative;
    default: return Sign::kUnknown;
  }
}

void ValueCheck::FindValues() {
  if (!is_assigned_.empty()) return;
  std::vector<StmtId> bodies;
  for (const FunctionId id : program_.functions.ids())
    bodies.push_back(program_.functions[id].body);
  is_assigned_ = AssignedIn(program_, bodies);
  declared_.resize(program_.vars.size());
  for (const StmtId stmt : program_.stmts.ids()) {
    if (const auto* declare = As<Declare>(program_, stmt))
      declared_[declare->var.index] = declare->init;
  }
}

}  // namespace clipc::rules
