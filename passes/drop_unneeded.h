// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::passes {

// Removes statements of `main`, also inside of branches and loops, that do nothing but give values
// to local variables that nothing else needs.
//
//   vec4 sum = vec4(0.0);                      =>
//   for (int i = 0; i < 4; i++) sum += k[i];
//   gl_Position = in_POSITION0;                     gl_Position = in_POSITION0;
//
// DropUnread leaves branches and loops as the author wrote them. Here they belong to outputs that
// the pixel shader of a pair does not read. A `switch` is kept or removed as a whole. Programs in
// which a need is found very late are left as they are.
//
// Requires and ensures Form::kInlined.
void DropUnneeded(ir::Program& program);

}  // namespace clipc::passes
