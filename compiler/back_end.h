// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "compiler/compile.h"
#include "compiler/job.h"
#include "ir/program.h"

namespace clipc {

// The pixel shader of a pair as its own job read it, in Form::kTyped.
struct PixelHalf {
  const Job& job;
  const ir::Program& typed;
};

// Takes the typed program of a job from Form::kTyped to everything in `result` that comes with the
// shaders. With a pixel half, the two are fitted to each other and written as one program. Errors
// are in the diagnostics of the job of the half that they are about; after them the result is not
// complete.
void RunBackEnd(const Job& job, const PixelHalf* half, ir::Program typed, CompileResult& result);

}  // namespace clipc
