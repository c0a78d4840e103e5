// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

namespace clipc::glsl {

// Writes a call of one of HLSL's functions, as far as the legalising passes left it, that gives a
// `type`.
Binding WriteIntrinsic(Code& code, ir::TypeId type, const ir::IntrinsicCall& node);

}  // namespace clipc::glsl
