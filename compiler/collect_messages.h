// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "compiler/job.h"
#include "compiler/result.h"

namespace clipc {

// Adds the messages of a job, and those of its pixel shader, which may be null, to the result. They
// have the order of the text, an include before the lines after it; the two shaders' are mixed if
// both are in one file. A message without a place stays after the one that was reported before it.
// What both shaders say is there once.
void CollectMessages(const Job& job, const Job* pixel, CompileResult& result);

}  // namespace clipc
