// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::link {

// Makes one variable of the outputs that are the rows of a matrix, as DXC and glslang declare it:
// `out mat3 tangents` in place of three vectors. The outputs are numbered by row (CheckOptions::
// stages_match_by_row), and the next stage is not known. `only_square`: GLSL ES 1.00 has no other
// matrices. Requires and ensures Form::kResolved.
void KeepMatricesWhole(ir::Program& program, bool only_square);

}  // namespace clipc::link
