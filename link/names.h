// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>

namespace clipc::link {

bool IsWordCharacter(char c);

// `name` as SPIRV-Cross spells it in GLSL: letters, digits and single underscores; "i.a[1]" is
// "i_a_1_".
std::string GlslNameOf(std::string_view name);

}  // namespace clipc::link
