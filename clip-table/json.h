// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "clip-table/clip_table.h"

namespace clipc::clip_table {

// The table in JSON, all of it ASCII: indented and ending in a newline, or in one line without a
// newline.
std::string JsonText(const ClipTable& table, bool one_line);

}  // namespace clipc::clip_table
