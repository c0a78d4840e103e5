// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/typing/constant.h"

#include <algorithm>

#include "ir/access.h"
#include "ir/evaluate.h"
#include "ir/scalar.h"

namespace clipc::typing {
namespace {

// Whether the expression begins with a variable that is not constant, as most conditions and
// indices do, which are so known without an evaluation.
bool BeginsWithVariable(const Program& program, ExprId expr) {
  while (!As<VarRef>(program, expr)) {
    expr = Visit(Overloaded{
                     [](const Binary& node) { return node.left; },
                     [](const OneOf<Unary, Convert, Splat> auto& node) { return node.operand; },
                     [](const OneOf<FieldRef, Index, Swizzle> auto& node) { return node.base; },
                     [](const auto&) { return ExprId{}; },
                 },
                 program.exprs[expr].node);
    if (!expr) return false;
  }
  return program.vars[As<VarRef>(program, expr)->var].storage != Storage::kConstant;
}

std::int64_t IntegerOf(std::uint64_t bits, Scalar kind) {
  return BaseOf(kind) == Scalar::kInt ? IntOf(bits) : static_cast<std::int64_t>(bits);
}

}  // namespace

std::optional<Constant> EvaluateConstant(const Program& program, ExprId expr) {
  const auto bits = ConstantBits(program, expr);
  if (!bits) return std::nullopt;
  const std::vector<Scalar> kinds = KindsOf(program.types, TypeIdOf(program, expr));
  Constant constant{kinds.empty() ? Scalar::kFloat : kinds.front(), {}};
  for (std::size_t i = 0; i < bits->size(); ++i)
    constant.components.push_back(NumberOf((*bits)[i], kinds[i]));
  return constant;
}

std::optional<std::int64_t> EvaluateInteger(const Program& program, ExprId expr) {
  const Type& type = TypeOf(program, expr);
  if (type.Components() != 1 || IsFloat(type.scalar)) return std::nullopt;
  if (const auto* literal = As<Literal>(program, expr))
    return IntegerOf(literal->bits, type.scalar);
  if (BeginsWithVariable(program, expr)) return std::nullopt;
  const auto bits = ConstantBits(program, expr);
  if (!bits) return std::nullopt;
  return IntegerOf(bits->front(), type.scalar);
}

bool IsLiteralList(const Program& program, ExprId expr) {
  const auto* construct = As<Construct>(program, expr);
  return construct &&
         std::ranges::all_of(program.expr_lists[construct->arguments],
                             [&](ExprId part) { return As<Literal>(program, part) != nullptr; });
}

}  // namespace clipc::typing
