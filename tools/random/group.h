// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "tools/random/statement.h"

namespace clipc::random {

// The buffers, the shared memory and the entry of a compute shader. Between its statements the
// threads of a group exchange values by memory that they share, with a barrier after each write and
// each read; and count in it by atomic operations, whose order does not matter. No thread returns
// before the end. At last every thread stores visible variables in elements of its own.
std::string MakeGroupEntry(Context& context);

}  // namespace clipc::random
