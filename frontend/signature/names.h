// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "ir/program.h"

// What goes into a shader and comes out of it, and `main`, which carries it. In namespace signature
// the program's types and functions have their plain names.
namespace clipc::signature {

using namespace ir;

}  // namespace clipc::signature
