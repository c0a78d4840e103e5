// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>

#include "backend-glsl/writer/code.h"

namespace clipc::glsl {

// Declares the constant buffers that are reached, as uniform blocks or plain uniforms: those that
// LayBlocks returned. The functions that read members by hand become helpers.
std::string WriteBlocks(Code& code, std::span<const GlslInfo::UniformBlock> blocks);

}  // namespace clipc::glsl
