// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>

#include "ir/program.h"

namespace clipc::passes {

// The number of statements at the beginning of `main` that read the inputs, and of those at its end
// that write the outputs. The shader's own are between them.
struct MainParts {
  std::size_t inputs = 0, outputs = 0;
};

// Puts the body of the entry point in the place of its call in `main`. Returns the parts of `main`
// for SplitVariables, which is the next pass.
//
//   Vertex v; v.position = in_POSITION0;
//   Varyings result = shader(v);
//   gl_Position = result.position;
//       =>
//   Vertex v; v.position = in_POSITION0;
//   Varyings o; o.position = view * float4(v.position, 1);
//   gl_Position = o.position;
//
// An entry point that returns early keeps its function and its call. The outputs keep their values,
// bit for bit. The same happens to the function of a patch's constants.
//
// Requires Form::kTargetClipSpace. Ensures Form::kInlined.
MainParts InlineEntry(ir::Program& program);

}  // namespace clipc::passes
