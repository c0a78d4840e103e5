// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/functions.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

void LowerComponents(Legalizer& legalizer) {
  legalizer.ForEach([&](ExprId expr) {
    const auto* call = As<IntrinsicCall>(legalizer.program, expr);
    if (!call) return;
    const ExprId first = legalizer.program.expr_lists[call->arguments][0];
    if (legalizer.IsNumeric(first) &&
        IsOfScalars(call->op, legalizer.TypeOf(first), legalizer.needs)) {
      legalizer.ByComponents(expr, NameOf(call->op), *call);
    }
  });
}

}  // namespace clipc::legalize
