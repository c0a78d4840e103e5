// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// What follows a `.` that is no method call, and what stands in brackets.
namespace clipc::check {

ir::ExprId CheckMember(Context& context, const ast::MemberExpr& expr, Span span);
void ReportNoMember(Context& context, ir::TypeId type, Name name, Span span);

}  // namespace clipc::check
