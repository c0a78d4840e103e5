// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "ir/program.h"
#include "tools/random/program.h"

namespace clipc::random {

// Names the first constant that clipc has elsewhere than layout.h says; empty if there is none.
std::string LayoutProblem(const Program& program, const ir::Program& checked);

}  // namespace clipc::random
