// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/expand_call.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <vector>

#include "frontend/check/value.h"
#include "frontend/typing/constant.h"
#include "ir/access.h"
#include "ir/intrinsic.h"

namespace clipc::check {
namespace {

// The min(max(x, low), high) that a call is whose bounds are known and the wrong way round: GLSL
// and SPIR-V leave it undefined, and HLSL does not ("clamp" among the intrinsic functions of
// Microsoft's reference; TranslateClamp in DXC's HLOperationLower.cpp).
ExprId ExpandClamp(Context& context, ExprId call) {
  const std::vector<ExprId> arguments = OperandsOf(context.program, call);
  const auto low = EvaluateConstant(context.program, arguments[1]);
  const auto high = low ? EvaluateConstant(context.program, arguments[2]) : std::nullopt;
  if (!high || std::ranges::equal(low->components, high->components, std::less_equal{}))
    return call;
  Builder at = context.At(context[call].span);
  const TypeId type = context.TypeIdOf(call);
  const ExprId least = at.IntrinsicOf(CommonIntrinsic::kMax, type, {arguments[0], arguments[1]});
  return at.IntrinsicOf(CommonIntrinsic::kMin, type, {least, arguments[2]});
}

// The exponent, if it is known and the reference compiler multiplies: dxc for 2 alone, fxc where
// that takes few multiplications (CanUseFxcMulOnlyPatternForPow in DXC's HLOperationLower.cpp,
// which has both rules).
std::optional<int> MultipliedExponent(const Context& context, ExprId exponent) {
  const auto value = EvaluateConstant(context.program, exponent);
  if (!value || value->components.empty()) return std::nullopt;
  const double first = value->components.front();
  constexpr double kMost = 1 << 20;
  const bool is_whole = first == std::trunc(first) && std::abs(first) <= kMost;
  const auto is_first = [&](double component) { return component == first; };
  if (!is_whole || !std::ranges::all_of(value->components, is_first)) return std::nullopt;
  const int power = static_cast<int>(first);
  if (context.program.profile.IsAtLeast(6, 0))
    return power == 2 ? std::optional(power) : std::nullopt;
  const auto size = static_cast<std::uint32_t>(std::abs(power));
  const int count = static_cast<int>(context.TypeOf(exponent).Components());
  const int most = power < 0 ? count + 1 : 2 * count + 1;
  const int needed = static_cast<int>(std::bit_width(size)) - 1 + std::popcount(size) - 1;
  return needed <= most ? std::optional(power) : std::nullopt;
}

// The products that fxc and dxc make of a call of `pow` whose exponent is a known whole number:
// pow(x, 2) of a negative x has a value in Direct3D so, and in GLSL and SPIR-V `pow` has none.
ExprId ExpandPower(Context& context, ExprId call) {
  const std::vector<ExprId> arguments = OperandsOf(context.program, call);
  const ExprId x = arguments[0];
  const auto power = MultipliedExponent(context, arguments[1]);
  const TypeId type = context.TypeIdOf(call);
  // A constant stays one for GLSL, which calls no function of the shader's in it.
  const bool is_matrix = context[type].kind == TypeKind::kMatrix;
  if (!power || (is_matrix && *power != 2) || EvaluateConstant(context.program, x)) return call;
  Builder at = context.At(context[call].span);
  const auto number = [&](double value) {
    return at.SplatTo(type, at.LiteralOf(context[type].scalar, value));
  };
  const int size = std::abs(*power);
  if (size == 0) return IsPure(context.program, x) ? number(1) : at.CommaOf(x, number(1));
  ExprId product = x;
  if (is_matrix) {
    Exprs steps;
    const ExprId held = Repeatable(context, x, steps);
    const ExprId copy = Clone(context.program, held);
    return WithPrologue(context, steps, at.BinaryOf(BinaryOp::kMul, held, copy));
  }
  if (size == 2 && IsPure(context.program, x) && RootOf(context.program, x))
    product = at.BinaryOf(BinaryOp::kMul, x, Clone(context.program, x));
  else if (size > 1)
    product = at.IntrinsicOf(CommonIntrinsic::kWholePower, type, {x, number(size)});
  return *power < 0 ? at.BinaryOf(BinaryOp::kDiv, number(1), product) : product;
}

}  // namespace

ExprId ExpandCall(Context& context, ExprId call) {
  const auto* node = context.GetIf<IntrinsicCall>(call);
  if (node && node->op == CommonIntrinsic::kClamp) return ExpandClamp(context, call);
  return node && node->op == CommonIntrinsic::kPow ? ExpandPower(context, call) : call;
}

}  // namespace clipc::check
