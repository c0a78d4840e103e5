// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

namespace clipc::check {

ir::ExprId CheckIndex(Context& context, const ast::IndexExpr& expr, Span span);

}  // namespace clipc::check
