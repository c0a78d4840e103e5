// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

// Expressions. A function called Write... appends an expression to code.out and returns how tightly
// it binds.
namespace clipc::glsl {

Binding WriteExpr(Code& code, ir::ExprId id);
// Writes the expression, in parentheses if it binds looser than `least`.
void WriteAt(Code& code, ir::ExprId id, Binding least);
// Writes the expressions as the arguments of a call, between its parentheses.
void WriteArguments(Code& code, std::span<const ir::ExprId> arguments);

// The expression in a text of its own.
Text ExprText(Code& code, ir::ExprId id);
// The expression as an argument of a call.
std::string Argument(Code& code, ir::ExprId id);

// Writes the expression between the brackets of an index; a literal is an int.
void WriteIndex(Code& code, ir::ExprId index);
std::string IndexValue(Code& code, ir::ExprId index);
// The indices "[i][2]" of textures[i][2]; empty if the expression is not an element.
std::string IndexPath(Code& code, ir::ExprId element);

}  // namespace clipc::glsl
