// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

namespace clipc::glsl {

// Whether the word is a keyword or a reserved word of any GLSL, GLSL ES or Vulkan GLSL version,
// which no identifier may be.
bool IsKeyword(std::string_view word);
// Whether some version has a built-in function of that name: a function or variable of the name
// would hide it, or is an error in ES.
bool IsBuiltinFunction(std::string_view word);
// Whether glslang declares a function of that name for an extension, in every shader. It refuses
// functions of the name with other results, and in ES whatever else outside functions has it.
bool IsExtensionFunction(std::string_view word);
// Whether the word is a qualifier in the brackets of `layout(...)` and no keyword.
bool IsLayoutWord(std::string_view word);

}  // namespace clipc::glsl
