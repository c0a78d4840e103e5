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

// Whether the expression is a ConstantBuffer<T>, or an element of an array of them, that is written
// as a block with an instance name.
bool IsInstance(const Code& code, ir::ExprId expr);
// The path "lights[i]" of an instance, before the name of a field of T.
std::string InstancePath(Code& code, ir::ExprId instance);
// The value of the instance as a T, put together from the block's members.
Text InstanceValue(Code& code, ir::ExprId instance);

}  // namespace clipc::glsl
