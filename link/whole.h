// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::link {

// Makes one variable of the outputs that are the rows of a matrix, as DXC and glslang declare it:
// `out mat3 tangents` in place of three vectors. The outputs are numbered by row (CheckOptions::
// stages_match_by_row), and the next stage is not known. Requires and ensures Form::kTyped.
void KeepMatricesWhole(ir::Program& program);

}  // namespace clipc::link
