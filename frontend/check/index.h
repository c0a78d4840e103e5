// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"
// Indices: array[i], vector[i], matrix[i], texture[i], texture.mips[level][i].
namespace clipc::check {

ExprId CheckNode(Context& context, const ast::IndexExpr& expr, Span span);

}  // namespace clipc::check
