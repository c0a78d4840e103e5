// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "ir/program.h"

// The rules of HLSL that need only the program, not the text. In namespace rules the program's
// types and functions have their plain names.
namespace clipc::rules {

using namespace ir;

}  // namespace clipc::rules
