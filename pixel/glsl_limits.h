// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>

// GLSL that glslang would take too much stack or time for, told before glslang reads it.
namespace clipc::pixel {

// Says what is too large in the text, "a statement has more than 4096 operators"; empty: nothing.
// Macros are not expanded, but what they may grow to is limited too; so ask for the preprocessed
// text again.
std::string GlslLimit(std::string_view text);

}  // namespace clipc::pixel
