// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "frontend/typing/names.h"
#include "ir/program.h"

// The rules of HLSL that need only the program, not the text. They report, and rewrite nothing. In
// namespace rules the program's types and functions have their plain names.
namespace clipc::rules {

using namespace ir;
using namespace typing;

}  // namespace clipc::rules
