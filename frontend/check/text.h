// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "frontend/check/context.h"

namespace clipc::check {

// An expression nearly as it was written, for messages and tables.
std::string TextOf(const Context& context, ast::ExprId id);
std::string QualifiedText(const Context& context, const ast::QualifiedName& name);

}  // namespace clipc::check
