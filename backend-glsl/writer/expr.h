// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

// Expressions.
namespace clipc::glsl {

Text ExprText(Code& code, ir::ExprId id);
// The expression as an argument of a call.
std::string Argument(Code& code, ir::ExprId id);
// The expression between the brackets of an index; a literal is an int.
std::string IndexValue(Code& code, ir::ExprId index);
// The index as an int, which may be an argument of a call.
std::string IntIndex(Code& code, ir::ExprId index);

// The indices "[i][2]" of textures[i][2]; empty if the expression is not an element.
std::string IndexPath(Code& code, ir::ExprId element);

}  // namespace clipc::glsl
