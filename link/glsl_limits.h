// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>

// Limits on GLSL that would take glslang too much stack or time, checked before glslang reads it.
namespace clipc::link {

// Returns the limit that the text exceeds, "a statement has more than 4096 operators"; empty if
// there is none. Macros are not expanded, but the size that they may grow to is limited too; so the
// preprocessed text must be checked again.
std::string GlslLimit(std::string_view text);

}  // namespace clipc::link
