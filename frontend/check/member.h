// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Members: fields, static members, swizzles of vectors and matrices.
namespace clipc::check {

ExprId CheckNode(Context& context, const ast::MemberExpr& expr, Span span);
// The struct whose member `expr` names, of an object of the type: that type, the base S in a.S::x,
// or in this.x the struct of the method, which an object of a derived type may call. An error type
// after an error, which was reported.
TypeId OwnerOf(Context& context, const ast::MemberExpr& expr, TypeId type);
// Reports that the type does not have the member `name`. `base` is the expression of that type;
// none: it has no text.
void ReportNoMember(Context& context, TypeId type, Name name, Span span, ast::ExprId base = {});

}  // namespace clipc::check
