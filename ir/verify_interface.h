// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>

#include "ir/program.h"

namespace clipc::ir {

// What of the program is no expression or statement: entry points, inputs, outputs, cbuffers,
// resources and clip planes. Ids are in range when it finds nothing.
std::optional<std::string> CheckInterface(const Program& program);

}  // namespace clipc::ir
