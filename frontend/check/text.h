// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "frontend/check/context.h"
// Parts of the syntax tree as text, for messages and tables.
namespace clipc::check {

// The names as a list for messages: "`a`, `b`".
std::string QuotedList(std::span<const std::string_view> names);
// The expression nearly as it was written.
std::string TextOf(const Context& context, ast::ExprId id);
// The name as text: "a::b".
std::string QualifiedText(const Context& context, const ast::QualifiedName& name);

}  // namespace clipc::check
