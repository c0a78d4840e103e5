// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

namespace clipc::check {

void Emit(Context& context, Span span, decltype(ir::Stmt::node) node);
// The temporaries that the expressions checked last need are declared before the statement they
// belong to.
void DeclareTemporaries(Context& context);
// An expression for what it does. The steps of a Comma are statements of their own, and the
// assignment that makes a temporary is its declaration.
void EmitValue(Context& context, ir::ExprId value);
// Makes statements of the steps before a value that is evaluated once, first thing in its
// statement.
ir::ExprId Unwrap(Context& context, ir::ExprId value);

}  // namespace clipc::check
