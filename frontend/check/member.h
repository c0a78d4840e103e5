// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Members: fields, static members, swizzles of vectors and matrices.
namespace clipc::check {

ExprId CheckNode(Context& context, const ast::MemberExpr& expr, Span span);
// Reports that the type does not have the member `name`. `base` is the expression of that type;
// none: it has no text.
void ReportNoMember(Context& context, TypeId type, Name name, Span span, ast::ExprId base = {});

}  // namespace clipc::check
