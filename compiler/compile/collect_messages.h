// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

#include "compiler/compile/job.h"
#include "compiler/compile/result.h"

namespace clipc {

// Adds the messages of the shaders of a program to the result. They have the order of the text, an
// include before the lines after it; those of two shaders are mixed if both are in one file. A
// message without a place stays after the one that was reported before it. What several shaders say
// is there once.
void CollectMessages(std::span<Job> jobs, CompileResult& result);

}  // namespace clipc
