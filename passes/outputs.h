// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "ir/program.h"

namespace clipc::passes {

// The output variable with that meaning; none when the shader has none.
ir::VarId FindOutput(const ir::Program& program, ir::Builtin builtin);

// A new output after all others, which only `main` may touch. `name` is what dumps show; the target has its own.
ir::VarId AddOutput(ir::Program& program, ir::Builtin builtin, std::string name, ir::TypeId type);

}  // namespace clipc::passes
