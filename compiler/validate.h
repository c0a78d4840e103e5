// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "backend-glsl/target.h"

namespace clipc {

struct Validation {
  bool ok = false;
  std::vector<std::string> problems;  // glslang's messages, "line 12: ..."
};

enum class ShaderStage { kVertex, kFragment };

// Compiles and links `glsl` as a shader of one stage with glslang, in this process. The first call
// for a GLSL version builds glslang's tables for it, tens of milliseconds; they stay for the life
// of the process. Thread-safe.
Validation Validate(const std::string& glsl, const glsl::Target& target, ShaderStage stage);

// "glslang 12.0.0".
std::string ValidatorName();

}  // namespace clipc
