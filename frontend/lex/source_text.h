// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/result.h"
#include "frontend/lex/source.h"

namespace clipc {

// The largest size of a source, in bytes: a Span has 31 bits for all files of a translation unit
// and all macro expansions in them.
inline constexpr std::size_t kMaxSourceBytes = std::size_t{256} << 20;

// Makes UTF-8 of UTF-16 with a byte order mark; leaves any other text as it is.
void ConvertUtf16(std::string& text);
// Whether the text begins with a byte order mark of UTF-16.
bool IsUtf16(std::string_view text);

// Reads a whole file, pipe or device as UTF-8; "-" is standard input. UTF-16 with a byte order mark
// is converted. A problem is the reason of the failure alone, which starts with a small letter.
Result<std::string> ReadText(const std::string& path);

// The text that defines the macros that exist before the first line: clipc's own, those of the
// compiler that the shader model belongs to, and the user's, which are in "<command line>" for
// messages.
std::string Predefines(const SourceInput& input);

}  // namespace clipc
