// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "ir/program.h"

namespace clipc::ir {

// The functions that `main` reaches, each once, callees before callers and `main` last: what is
// asked of them in this order needs no recursion, as generated shaders have call chains of any
// length. Requires functions without recursion.
std::vector<FunctionId> CalleesFirst(const Program& program);

}  // namespace clipc::ir
