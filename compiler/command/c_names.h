// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

namespace clipc {

// Whether the name is a keyword of C++20 or C23, so that no variable of a header can have it.
bool IsKeywordInC(std::string_view name);

// Whether the name may be a macro of <stddef.h> or <stdint.h>, or one that a compiler defines.
bool IsMacroInC(std::string_view name);

}  // namespace clipc
