// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <functional>

#include "compiler/compile/compile.h"

namespace clipc {

// Calls `work` for each index below `count`, on `jobs` threads with a compiler each, and `finish`
// on this thread with what it returned, in the order of the indices. Ends early when `finish`
// returns false. However slow `finish` is, only a few results wait for it.
void CompileInOrder(std::size_t count, unsigned jobs,
                    const std::function<CompileResult(std::size_t index, Compiler& compiler)>& work,
                    const std::function<bool(std::size_t index, CompileResult result)>& finish);

}  // namespace clipc
