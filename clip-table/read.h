// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "clip_table.h"
#include "static_table.h"

namespace clipc::clip_table {

/// Every reader takes the bytes of a whole file. Whatever the bytes are, the result is a table that
/// ProblemOf finds good, or an error that says what is wrong and where.

/// Reads what WriteJson wrote. White space and the order of the keys are free; unknown and repeated
/// keys are errors.
Result<ClipTable> ReadJson(std::string_view text);

/// Reads what WriteBinary wrote, or a DXBC container (a compiled shader of fxc) with such a block
/// in its SHDR or SHEX chunk. A record of several registers gives one plane for each register. The
/// container's hash is not checked.
Result<ClipTable> ReadBinary(std::string_view bytes);

/// Converts the table of a header that WriteHeader wrote, for a program that was compiled with it.
Result<ClipTable> FromStatic(const StaticClipTable& table);

/// Reads JSON or the binary form; the first bytes tell which it is.
Result<ClipTable> Read(std::string_view bytes);

}  // namespace clipc::clip_table
