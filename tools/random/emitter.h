// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "tools/random/interface.h"

namespace clipc::random {

// The structs and the entry of a geometry shader, `planes` before it: it takes primitives of any
// kind and emits up to five vertices, some of them only if a condition holds, with strips that end
// between them. It may append more than it says; those are dropped.
std::string MakeEmitterEntry(Context& context, const std::string& planes);

}  // namespace clipc::random
