// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

// How expressions read constant buffers.
namespace clipc::glsl {

// The whole member.
Text UniformText(Code& code, ir::VarId member);
// One element of a member that is an array.
Text UniformElement(Code& code, ir::VarId member, ir::ExprId index);

// Whether the expression is a ConstantBuffer<T>, or an element of an array of them, that is written
// as a block with an instance name.
bool IsInstance(const Code& code, ir::ExprId expr);
// "lights[i]", which takes a field of T.
std::string InstancePath(Code& code, ir::ExprId instance);
// The T, put together from the block's members.
Text InstanceValue(Code& code, ir::ExprId instance);

}  // namespace clipc::glsl
