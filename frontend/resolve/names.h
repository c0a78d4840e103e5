// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "frontend/rules/names.h"
#include "ir/program.h"

// The passes that take a program from Form::kTyped to Form::kResolved. In namespace resolve the
// program's types and functions have their plain names.
namespace clipc::resolve {

using namespace ir;
using namespace rules;

}  // namespace clipc::resolve
