// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"
// Switch statements.
namespace clipc::check {

void CheckNode(Context& context, const ast::SwitchStmt& stmt, Span span);

}  // namespace clipc::check
