// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// The order of partial specialisations, as in C++: struct S<vector<T, N>, N> is more special than
// struct S<T, N>.
namespace clipc::check {

// Whether `general` fits every use that `special` fits. Both are specialisations of one template.
bool IsAtLeastAsSpecial(Context& context, const ast::StructDecl& special,
                        const ast::StructDecl& general);

}  // namespace clipc::check
