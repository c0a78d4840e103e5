// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "ir/program.h"

namespace clipc::passes {

// The output variable with the meaning `builtin`; none if the shader does not have it.
ir::VarId FindOutput(const ir::Program& program, ir::Builtin builtin);

// Whether the variable is an input whose name costs nothing to repeat; a built-in one may stand for
// a computation.
bool IsPlainInput(const ir::Program& program, ir::VarId var);

// The value of `output` if `main` writes `output` exactly once, as a copy of a local variable or of
// one of its fields; otherwise none. Reading the local costs a target less than reading the output
// again. The expression has its parent: clone it for each use.
ir::ExprId LocalWrittenTo(const ir::Program& program, ir::VarId output);

// Removes from `main` the one statement that LocalWrittenTo found. The caller writes the output
// again.
void RemoveWrite(ir::Program& program, ir::VarId output);

// Adds an output after all others, which only `main` may touch. Dumps show `name`; the target gives
// the output a name of its own.
ir::VarId AddOutput(ir::Program& program, ir::Builtin builtin, std::string name, ir::TypeId type);

}  // namespace clipc::passes
