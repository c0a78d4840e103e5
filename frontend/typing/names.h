// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "ir/program.h"

// What an operator, a function or a method of HLSL is, by the types of its operands. In namespace
// typing the program's types and functions have their plain names.
namespace clipc::typing {

using namespace ir;

}  // namespace clipc::typing
