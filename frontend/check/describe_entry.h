// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/clip_planes.h"
#include "frontend/check/context.h"
#include "frontend/check/entry_point.h"

namespace clipc::check {

// The text of the entry point; the program is left to the caller.
EntryPoint Describe(const Context& context, FunctionInfoId entry, const AttributeLists& attributes);

}  // namespace clipc::check
