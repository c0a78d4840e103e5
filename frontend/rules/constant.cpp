// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/constant.h"

#include <algorithm>

#include "ir/access.h"
#include "ir/evaluate.h"
#include "ir/scalar.h"

namespace clipc::rules {

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
  const auto bits = ConstantBits(program, expr);
  if (!bits) return std::nullopt;
  return BaseOf(type.scalar) == Scalar::kInt ? IntOf(bits->front())
                                             : static_cast<std::int64_t>(bits->front());
}

bool IsLiteralList(const Program& program, ExprId expr) {
  const auto* construct = As<Construct>(program, expr);
  return construct &&
         std::ranges::all_of(program.expr_lists[construct->arguments],
                             [&](ExprId part) { return As<Literal>(program, part) != nullptr; });
}

}  // namespace clipc::rules
