// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "compiler/job.h"
#include "compiler/result.h"
#include "ir/program.h"
#include "ir/run_passes.h"

namespace clipc {

// The passes' options of a job, which append the programs that the request wants to see to `dump`.
// Both must outlive them.
ir::PassOptions PassesOf(const Job& job, std::string& dump);

// The pixel shader of a pair as its own job read it, in Form::kResolved.
struct PixelHalf {
  const Job& job;
  const ir::Program& typed;
};

// Takes the typed program of a job from Form::kResolved to everything in `result` that comes with
// the shaders. With a pixel half, the two are fitted to each other and written as one program.
// Errors are in the diagnostics of the job of the half that they are about; after them the result
// is not complete.
void RunBackEnd(const Job& job, const PixelHalf* half, ir::Program typed, CompileResult& result);

}  // namespace clipc
