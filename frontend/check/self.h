// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Which methods change the object they are called on. Those that do take it `inout`, the others
// `in`. The text decides, before any name of the body is resolved, so the answer may be "yes" where
// "no" would do.
namespace clipc::check {

bool MayChangeSelf(Context& context, const ast::FunctionDecl& decl, ScopeId scope);

}  // namespace clipc::check
