// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/constant.h"

#include "ir/evaluate.h"
#include "ir/scalar.h"

namespace clipc {

std::optional<Constant> EvaluateConstant(const ir::Program& program, ir::ExprId expr) {
  const auto bits = ir::ConstantBits(program, expr);
  if (!bits) return std::nullopt;
  const std::vector<ir::Scalar> kinds = ir::KindsOf(program.types, program.exprs[expr].type);
  Constant constant{kinds.empty() ? ir::Scalar::kFloat : kinds.front(), {}};
  for (std::size_t i = 0; i < bits->size(); ++i)
    constant.components.push_back(ir::NumberOf((*bits)[i], kinds[i]));
  return constant;
}

std::optional<std::int64_t> EvaluateInteger(const ir::Program& program, ir::ExprId expr) {
  const ir::Type& type = program.types[program.exprs[expr].type];
  if (type.Components() != 1 || ir::IsFloat(type.scalar)) return std::nullopt;
  const auto bits = ir::ConstantBits(program, expr);
  if (!bits) return std::nullopt;
  return ir::BaseOf(type.scalar) == ir::Scalar::kInt ? ir::IntOf(bits->front())
                                                     : static_cast<std::int64_t>(bits->front());
}

}  // namespace clipc
