// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// Makes the discards after which neighbouring pixels may still be asked, for a derivative or a
// level of detail, wait for the end of `main`. Direct3D's discard ends what a pixel draws, not its
// run; that of GLSL ends the run, and leaves the neighbours without a derivative.
//
//   if (alpha < 0.5) discard;             =>    bool is_discarded = false;
//   color = map.Sample(linear, uv);
//                                               if (alpha < 0.5) is_discarded = true;
//                                               color = map.Sample(linear, uv);
//                                               if (is_discarded) discard;
//
// Stores and atomic operations happen only while the pixel is not discarded. A clip() that is a
// part of an expression becomes a call of a function that discards.
//
// Requires and ensures Form::kInlined.
void DeferDiscards(ir::Program& program);

}  // namespace clipc::passes
