// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

#include "compiler/compile/job.h"
#include "compiler/compile/result.h"

namespace clipc {

// Fills the outputs with the main file as HLSL, in which the clip planes of the request's entry
// points are clip distances; the file itself if they have none. Only what the signatures and the
// planes name is read: elsewhere the file may have what clipc does not know. A second job is that
// of the shader that discards under lowering kDiscard; its file is an output of its own, unless the
// request says that it is the main one.
void RewriteHlsl(std::span<Job> jobs, CompileResult& result);

}  // namespace clipc
