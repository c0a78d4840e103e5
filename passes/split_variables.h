// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "ir/program.h"

namespace clipc::passes {

// The statements of `main`: those that read the inputs, those of the shader, those that write the
// outputs.
struct MainParts {
  std::vector<ir::StmtId> before, body, after;
};

// Whether a statement may change the variable or a part of it.
bool IsAssigned(const ir::Program& program, ir::StmtId stmt, ir::VarId var);

// Takes apart the structs that only carry inputs or outputs and that nothing uses as a whole. A
// field that passes an input on, or whose last value goes to an output, is that input or output
// from then on; another becomes a variable of its own. Others get their inputs in one statement.
// Gives back the statements of `main`.
std::vector<ir::StmtId> SplitVariables(ir::Program& program, const MainParts& parts);

}  // namespace clipc::passes
