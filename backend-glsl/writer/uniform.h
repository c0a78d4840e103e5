// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

// Reads of constant buffers in expressions.
namespace clipc::glsl {

// Writes the value of the whole member.
Binding WriteUniform(Code& code, ir::VarId member);
// Writes the value of one element of a member that is an array.
Binding WriteUniformElement(Code& code, ir::VarId member, ir::ExprId index);

}  // namespace clipc::glsl
