// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "backend-glsl/target.h"

namespace clipc {

enum class ShaderStage { kVertex, kFragment };

// Compiles and links `glsl` as a shader of one stage with glslang, in this process. Returns
// glslang's messages, "line 12: ...": none for a valid shader, at least one for another. The first
// call for a GLSL version builds glslang's tables for it, which takes tens of milliseconds; they
// stay for the life of the process. Thread-safe.
std::vector<std::string> Validate(const std::string& glsl, const glsl::Target& target,
                                  ShaderStage stage);

// "glslang 12.0.0".
std::string ValidatorName();

}  // namespace clipc
