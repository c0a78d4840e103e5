// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "ir/program.h"

namespace clipc {

// Gives a register to every cbuffer and resource that the user gave none. Buffers take the free
// registers in the order of their declarations, but $Globals comes first and $Params last; textures
// and samplers follow the same rule. Reports two explicit bindings of one register, and numbers out
// of range. Requires that only buffers that the shader reaches are in the program.
void AssignRegisters(ir::Program& program, Diagnostics& diagnostics);

}  // namespace clipc
