// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "compiler/job.h"
#include "compiler/result.h"

namespace clipc {

// Fills the outputs with the main file as HLSL, in which the clip planes of the request's entry
// points are clip distances; the file itself if they have none. Only what the signatures and the
// planes name is read: elsewhere the file may have what clipc does not know. `pixel` is the job of
// the pixel shader that discards under lowering kDiscard, or null; of a pair, its file is an
// output of its own, and otherwise both shaders are in one file.
void RewriteHlsl(const Job& job, const Job* pixel, CompileResult& result);

}  // namespace clipc
