// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

namespace clipc::glsl {

// Writes a call of one of HLSL's functions, as far as the legalising passes left it, that gives a
// `type`.
Binding WriteIntrinsic(Code& code, ir::TypeId type, const ir::IntrinsicCall& node);

// GLSL's function that orders memory as a barrier of HLSL's does, which may wait too.
std::string_view MemoryBarrierOf(ir::Intrinsic op);

// GLSL's name of a function that gives the number of a bit or of bits, as an int; empty for others.
std::string_view BitNumberFunction(ir::Intrinsic op);

}  // namespace clipc::glsl
