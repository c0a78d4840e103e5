// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/constant.h"

#include <variant>

#include "ir/scalar.h"

namespace clipc::legalize {

using namespace ir;

std::optional<Constant> ConstantOf(const Program& program, ExprId expr) {
  const Scalar kind = program.types[program.exprs[expr].type].scalar;
  const auto& node = program.exprs[expr].node;
  if (const auto* literal = std::get_if<Literal>(&node)) return Constant{literal->bits, kind};
  if (std::holds_alternative<Zero>(node)) return Constant{0, kind};
  if (const auto* splat = std::get_if<Splat>(&node)) return ConstantOf(program, splat->operand);
  if (const auto* convert = std::get_if<Convert>(&node)) {
    const auto operand = ConstantOf(program, convert->operand);
    if (!operand) return std::nullopt;
    return Constant{ConvertBits(operand->bits, operand->kind, kind), kind};
  }
  const auto* unary = std::get_if<Unary>(&node);
  if (!unary || unary->op != UnaryOp::kNegate) return std::nullopt;
  const auto operand = ConstantOf(program, unary->operand);
  if (!operand || !IsFloat(kind)) return std::nullopt;
  const std::uint64_t sign = BaseOf(kind) == Scalar::kDouble ? std::uint64_t{1} << 63 : 1u << 31;
  return Constant{operand->bits ^ sign, kind};
}

bool AreInOrder(const std::optional<Constant>& low, const std::optional<Constant>& high) {
  return low && high && NumberOf(low->bits, low->kind) < NumberOf(high->bits, high->kind);
}

}  // namespace clipc::legalize
