// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// The question whether a method changes the object that it is called on. If so, it takes the object
// `inout`, otherwise `in`. The text decides, before any name of the body is resolved, so a method
// may count as one that changes its object although it does not.
namespace clipc::check {

// Whether the method may change its object; `scope` is the scope of its struct.
bool MayChangeSelf(Context& context, const ast::FunctionDecl& decl, ScopeId scope);

// Reports the calls of methods that change a member of a constant buffer (fxc X3025): here the
// bodies decide, which must have been checked without errors.
void CheckUniformCalls(Context& context);

}  // namespace clipc::check
