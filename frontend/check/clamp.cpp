// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/clamp.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "frontend/typing/constant.h"
#include "ir/access.h"
#include "ir/intrinsic.h"

namespace clipc::check {

ExprId ExpandClamp(Context& context, ExprId call) {
  const auto* node = context.GetIf<IntrinsicCall>(call);
  if (!node || node->op != CommonIntrinsic::kClamp) return call;
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

}  // namespace clipc::check
