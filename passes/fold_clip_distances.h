// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// Leaves out the last clip distances that can clip nothing: those that are constants from 0 up,
// whichever way the shader takes. The array becomes shorter, or goes; the others keep their
// indices. A shader whose entry point returns early keeps all.
//
//   float2 distances = float2(dot(position, plane), 1);        float2 distances = float2(dot(position, plane), 1);
//   gl_ClipDistance[0] = distances.x;                     =>   gl_ClipDistance[0] = distances.x;
//   gl_ClipDistance[1] = distances.y;
//
// Requires and ensures Form::kInlined.
void FoldClipDistances(ir::Program& program);

}  // namespace clipc::passes
