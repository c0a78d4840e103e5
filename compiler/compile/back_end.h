// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <vector>

#include "compiler/compile/job.h"
#include "compiler/compile/result.h"
#include "ir/program.h"

namespace clipc {

// Takes the typed shaders of a program, one for each job, from Form::kResolved to the outputs in
// `result`: they are fitted to each other and written as one program. Errors are in the diagnostics
// of the job that they are about; after them the outputs are not complete.
void RunBackEnd(std::span<Job> jobs, std::vector<ir::Program> typed, CompileResult& result);

}  // namespace clipc
