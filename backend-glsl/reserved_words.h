// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

namespace clipc::glsl {

// Keywords and reserved words of any GLSL, GLSL ES or Vulkan GLSL version: no identifier may be
// one.
bool IsKeyword(std::string_view word);
// Functions that some version has built in: a function or variable of that name would hide it, or
// is an error in ES.
bool IsBuiltinFunction(std::string_view word);

}  // namespace clipc::glsl
