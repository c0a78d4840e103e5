// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include <spirv_cross/spirv_cross.hpp>

#include "tools/draw/inputs.h"
#include "tools/draw/vulkan/spirv.h"

namespace clipc::draw::vulkan {

// Returns reflect(compiler). Throws DrawError where SPIRV-Cross cannot read the shader.
template <typename Reflect>
auto Reflected(const Spirv& spirv, Reflect&& reflect) {
  try {
    return reflect(spirv_cross::Compiler(spirv));
  } catch (const spirv_cross::CompilerError& error) {
    throw DrawError(std::string("SPIRV-Cross cannot read the shader: ") + error.what());
  }
}

}  // namespace clipc::draw::vulkan
