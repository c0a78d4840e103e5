// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// The question whether a method changes the object that it is called on. If so, it takes the object
// `inout`, otherwise `in`. The text decides, before any name of the body is resolved, so a method
// may count as one that changes its object although it does not.
namespace clipc::check {

// Whether the method may change its object; `scope` is the scope of its struct.
bool MayChangeSelf(Context& context, const ast::FunctionDecl& decl, ScopeId scope);

}  // namespace clipc::check
