// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "backend-glsl/target.h"
#include "base/stage.h"

namespace clipc {

// Compiles and links `glsl` as a shader of one stage with glslang, in this process. Returns
// glslang's messages, "line 12: ...": none for a valid shader, at least one for another. The first
// call for a GLSL version builds glslang's tables for it, which takes tens of milliseconds; they
// stay for the life of the process. Thread-safe.
std::vector<std::string> Validate(const std::string& glsl, const glsl::Target& target, Stage stage);

// What valid GLSL for the target has in it that the validator does not support; empty if there is
// nothing, so that a message of Validate is about a mistake. docs/language.md, "GLSL that glslang
// refuses", is the list.
std::string_view UnknownToValidator(std::string_view glsl, const glsl::Target& target);

// The name and version of the validator, "glslang 12.0.0".
std::string ValidatorName();

}  // namespace clipc
