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
// The expression as HLSL of the same meaning: macros are expanded, and parentheses are where they
// are needed, also around the whole if its operator binds less tightly than `precedence`, one of
// kBinaryOperators.
std::string TextOf(const Context& context, ast::ExprId id, int precedence = 0);
// The type: "A::vector<float, 4>".
std::string TypeText(const Context& context, ast::TypeId id);
// The dimensions of an array: "[2][]".
std::string DimensionText(const Context& context, List<ast::ExprId> dimensions);
// The name as text: "a::b".
std::string QualifiedText(const Context& context, const ast::QualifiedName& name);

}  // namespace clipc::check
