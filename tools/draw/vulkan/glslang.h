// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include <glslang/Public/ShaderLang.h>

#include "compiler/compile/validate.h"
#include "tools/draw/inputs.h"
#include "tools/draw/vulkan/spirv.h"

// Shaders to SPIR-V, by glslang.
namespace clipc::draw::vulkan {

// Initializes glslang once and never frees it, as compiler/compile/validate.cpp does.
void InitializeGlslang();

// Parses and links the shader, and writes it as SPIR-V. Throws DrawError where glslang refuses it.
Spirv Translate(glslang::TShader& shader, glslang::TShader::Includer& includer,
                EShMessages messages, bool optimize);

// Compiles GLSL for Vulkan. Throws DrawError where glslang refuses it.
Spirv SpirvOfGlsl(const std::string& glsl, Stage stage = Stage::kVertex);

}  // namespace clipc::draw::vulkan
