// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Which methods change the object that they are called on. Those that do take it `inout`, the
// others `in`. The text decides, before any name of the body is resolved, so a method may count as
// one that changes its object although it does not.
namespace clipc::check {

// Whether the method may change its object; `scope` is that of its struct.
bool MayChangeSelf(Context& context, const ast::FunctionDecl& decl, ScopeId scope);

}  // namespace clipc::check
