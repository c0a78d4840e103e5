// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "ir/program.h"

namespace clipc::passes {

// The output variable with that meaning; none when the shader has none.
ir::VarId FindOutput(const ir::Program& program, ir::Builtin builtin);

// The local variable, or the part of one, that `main` copies to that output, once, as its last word
// on it; none when the output gets something else. To read it costs a target less than to read the
// output. Clone it for each use.
ir::ExprId LocalBehind(const ir::Program& program, ir::VarId output);

// Takes that one copy out of `main`; whoever calls this writes the output again.
void RemoveWrite(ir::Program& program, ir::VarId output);

// A new output after all others, which only `main` may touch. `name` is what dumps show; the target
// has its own.
ir::VarId AddOutput(ir::Program& program, ir::Builtin builtin, std::string name, ir::TypeId type);

}  // namespace clipc::passes
