// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "clip-table/clip_table.h"
#include "clip-table/static_table.h"

namespace clipc::clip_table {

// All readers take the bytes of a whole file. Whatever the bytes are, the answer is a table that
// ProblemOf finds good, or an error that says what is wrong and where.

// What WriteJson wrote; white space and the order of the keys are free, unknown and repeated keys
// are errors.
Result<ClipTable> ReadJson(std::string_view text);

// What WriteBinary wrote, or a DXBC container (a compiled shader of fxc) with such a block in its
// SHDR or SHEX chunk. A record of several registers gives one plane for each. The container's hash
// is not checked.
Result<ClipTable> ReadBinary(std::string_view bytes);

// What WriteHeader wrote. A comment in it carries the table in JSON; the C++ below must be what
// WriteHeader makes of that table, so a header that was edited by hand is an error. Line ends may
// have become CR LF.
Result<ClipTable> ReadHeader(std::string_view text);

// What such a header holds, for a program that was compiled with it.
Result<ClipTable> FromStatic(const StaticClipTable& table);

// Any of the three, told apart by the first bytes.
Result<ClipTable> Read(std::string_view bytes);

}  // namespace clipc::clip_table
