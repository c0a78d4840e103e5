// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <array>
#include <utility>

#include "ir/intrinsic_list.h"
#include "ir/scalar.h"
#include "legalize/constant.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

constexpr double kLog10Of2 = 0.30102999566398120;
constexpr double kByteOfColor = 255.001953;  // the factor in fxc's code

bool IsUnsignedNumber(const Legalizer& legalizer, ExprId expr) {
  return IsUnsigned(legalizer.TypeOf(expr).scalar);
}

// Makes `expr` a call of fmod(x, y) { return x - y * trunc(x / y); } or of imod, which rounds to
// zero without trunc.
void BecomeModulo(Legalizer& legalizer, ExprId expr, ExprId left, ExprId right) {
  const TypeId type = legalizer.program.exprs[expr].type;
  const bool is_floating = legalizer.ShapeAt(expr).IsFloating();
  const Parameter parameters[] = {{"x", type}, {"y", type}};
  const ExprId arguments[] = {left, right};
  legalizer.BecomeCall(expr, is_floating ? "fmod" : "imod", parameters, arguments,
                       [&](HelperBody& body) {
                         ExprId whole = body.b.BinaryOf(BinaryOp::kDiv, body[0], body[1]);
                         if (is_floating)
                           whole = body.b.IntrinsicOf(Intrinsic::kTrunc, type, {whole});
                         const ExprId product = body.b.BinaryOf(BinaryOp::kMul, body[1], whole);
                         body.Return(body.b.BinaryOf(BinaryOp::kSub, body[0], product));
                       });
}

// The count of a shift modulo the number of bits, as HLSL takes it; GLSL leaves shifts by more than
// 31 undefined.
ExprId Count(Legalizer& legalizer, ExprId count, std::uint32_t mask) {
  Program& program = legalizer.program;
  const TypeId type = program.exprs[count].type;
  if (const auto* splat = As<Splat>(program, count)) {
    const ExprId scalar = Count(legalizer, splat->operand, mask);
    return legalizer.At(count).Add(type, Splat{scalar});
  }
  Builder b = legalizer.At(count);
  const Scalar kind = program.types[type].scalar;
  const auto* old_mask = As<Binary>(program, count);
  if (old_mask && old_mask->op == BinaryOp::kBitAnd) {
    const auto bits = ConstantOf(program, old_mask->right);
    if (bits && bits->bits <= mask) return count;
  }
  const auto number = ConstantOf(program, count);
  if (number && NumberOf(number->bits, kind) >= 0) {
    return b.SplatTo(type, b.LiteralOf(kind, static_cast<double>(number->bits & mask)));
  }
  return b.BinaryOf(BinaryOp::kBitAnd, count, b.SplatTo(type, b.LiteralOf(kind, mask)));
}

std::uint32_t MaskOf(Scalar shifted) {
  return BaseOf(shifted) == Scalar::kInt64 || BaseOf(shifted) == Scalar::kUint64 ? 63 : 31;
}

// The count of a shift of `shifted`. Mesa refuses counts of 64 bits.
ExprId CountFor(Legalizer& legalizer, ExprId count, ExprId shifted) {
  count = Count(legalizer, count, MaskOf(legalizer.TypeOf(shifted).scalar));
  const bool is_wide = IsWide(legalizer.TypeOf(count).scalar);
  return is_wide ? legalizer.At(count).ConvertTo(Scalar::kUint, count) : count;
}

void LowerBinary(Legalizer& legalizer, ExprId expr, Binary node) {
  if (node.op == BinaryOp::kMod) {
    // GLSL's % is undefined when an operand is negative.
    const bool is_native = IsUnsignedNumber(legalizer, expr) && !legalizer.needs.signed_integers;
    if (!is_native) BecomeModulo(legalizer, expr, node.left, node.right);
  } else if (IsShift(node.op)) {
    node.right = CountFor(legalizer, node.right, node.left);
    legalizer.program.exprs[expr].node = node;
  }
}

// The expression that the call is short for; none for other calls.
ExprId Meaning(Legalizer& legalizer, ExprId expr, Intrinsic op,
               const std::array<ExprId, 3>& argument) {
  Builder b = legalizer.At(expr);
  const ExprId x = argument[0];
  const TypeId type = b.TypeOf(x);
  const Scalar kind = legalizer.program.types[type].scalar;
  const auto number = [&](double value) { return b.SplatTo(type, b.LiteralOf(kind, value)); };
  const auto call = [&](Intrinsic function, ExprId of) {
    return b.IntrinsicOf(function, type, {of});
  };
  switch (op) {
    case Intrinsic::kRcp: return b.BinaryOf(BinaryOp::kDiv, number(1), x);
    case Intrinsic::kLog10:
      return b.BinaryOf(BinaryOp::kMul, call(Intrinsic::kLog2, x), number(kLog10Of2));
    case Intrinsic::kLdexp:
      return b.BinaryOf(BinaryOp::kMul, x, call(Intrinsic::kExp2, argument[1]));
    case Intrinsic::kMad:
      return b.BinaryOf(BinaryOp::kAdd, b.BinaryOf(BinaryOp::kMul, x, argument[1]), argument[2]);
    case Intrinsic::kD3dColorToUbyte4: {
      const ExprId zyxw = b.Swizzled(x, {2, 1, 0, 3});
      return b.ConvertTo(Scalar::kInt, b.BinaryOf(BinaryOp::kMul, zyxw, number(kByteOfColor)));
    }
    case Intrinsic::kAbs: return IsUnsigned(kind) ? x : ExprId{};
    case Intrinsic::kSign: {
      if (!IsUnsigned(kind)) return {};
      const ExprId least = b.IntrinsicOf(Intrinsic::kMin, type, {x, number(1)});
      return b.ConvertTo(legalizer.TypeOf(expr).scalar, least);
    }
    default: return {};
  }
}

void LowerCall(Legalizer& legalizer, ExprId expr, const IntrinsicCall& call) {
  const auto listed = std::as_const(legalizer.program).expr_lists[call.arguments];
  std::array<ExprId, 3> arguments{};
  if (listed.size() > arguments.size()) return;
  std::ranges::copy(listed, arguments.begin());
  if (!legalizer.IsNumeric(arguments[0])) return;
  if (call.op == Intrinsic::kFmod) {
    return BecomeModulo(legalizer, expr, arguments[0], arguments[1]);
  }
  const ExprId meaning = Meaning(legalizer, expr, call.op, arguments);
  if (meaning) legalizer.Become(expr, meaning);
}

}  // namespace

void LowerArithmetic(Legalizer& legalizer) {
  legalizer.ForEach([&](ExprId expr) {
    const Program& program = legalizer.program;
    if (const auto* binary = As<Binary>(program, expr)) {
      LowerBinary(legalizer, expr, *binary);
    } else if (const auto* call = As<IntrinsicCall>(program, expr)) {
      LowerCall(legalizer, expr, IntrinsicCall(*call));
    } else if (const auto* assign = As<Assign>(program, expr);
               assign && assign->op && IsShift(*assign->op)) {
      Assign shift = *assign;
      shift.value = CountFor(legalizer, shift.value, shift.target);
      legalizer.program.exprs[expr].node = shift;
    }
  });
}

}  // namespace clipc::legalize
