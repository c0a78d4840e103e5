// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

// Reads and writes through textures and buffers.
namespace clipc::glsl {

Text ObjectText(Code& code, ir::TypeId type, const ir::ObjectCall& node);

// The object as an argument of GLSL's functions, with the sampler it is read with, if any.
std::string ObjectName(Code& code, ir::ExprId object, ir::ExprId sampler = {});

}  // namespace clipc::glsl
