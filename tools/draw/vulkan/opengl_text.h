// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "tools/draw/build.h"

namespace clipc::draw {

// The GLSL that SPIRV-Cross makes of the SPIR-V that clipc writes by itself for OpenGL; empty where
// it does not, for GLSL before 4.50, and where SPIRV-Cross cannot say what the module means.
std::string GlslOfSpirv(const Shader& shader);

}  // namespace clipc::draw
