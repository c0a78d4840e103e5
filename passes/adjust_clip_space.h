// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

struct ClipSpaceOptions {
  bool negative_one_to_one = false;  // the target's depth range is [-w, w]: z becomes 2z - w
  bool flip_y = false;               // y becomes -y
  bool host_flips_y = false;         // the application's matrices do that: y stays as it is
};

// Converts the position from Direct3D's clip space (y up, 0 <= z <= w) to the target's, at the end
// of `main`.
//
// Requires Form::kNoClipPlanes. Ensures Form::kTargetClipSpace.
//
//   gl_Position = result.position;    =>    gl_Position = result.position;
//                                           gl_Position.y = -gl_Position.y;
//                                           gl_Position.z = 2.0 * gl_Position.z - gl_Position.w;
void AdjustClipSpace(ir::Program& program, const ClipSpaceOptions& options);

}  // namespace clipc::passes
