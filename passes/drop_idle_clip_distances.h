// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// Removes trailing clip distances that are a constant from 0 up on every path, and so can never
// clip. The array becomes shorter, or the output is removed; the other distances keep their
// indices.
//
//   float2 distances = float2(dot(position, plane), 1);
//   gl_ClipDistance[0] = distances.x;
//   gl_ClipDistance[1] = distances.y;
//       =>
//   float2 distances = float2(dot(position, plane), 1);
//   gl_ClipDistance[0] = distances.x;
//
// A shader whose entry point returns early keeps all of its distances.
//
// Requires and ensures Form::kInlined.
void DropIdleClipDistances(ir::Program& program);

}  // namespace clipc::passes
