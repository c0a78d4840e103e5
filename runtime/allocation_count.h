// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>

namespace clipc::runtime {

// How often this test program has called operator new, so that a test can say that nothing did.
std::size_t AllocationCount();

}  // namespace clipc::runtime
