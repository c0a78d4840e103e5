// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>

#include "ir/program.h"

namespace clipc::ir {

// The first thing that is wrong with the program's entry points, inputs, outputs, cbuffers,
// resources and clip planes; none when they are right, and then their ids are in range.
std::optional<std::string> CheckInterface(const Program& program);

}  // namespace clipc::ir
