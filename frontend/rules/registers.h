// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/rules.h"

namespace clipc::rules {

// Gives a register to every cbuffer and resource to which the user gave none. Buffers take the free
// registers in the order of their declarations, but $Globals comes first and $Params last; textures
// and samplers follow the same rule. Reports two explicit bindings of one register, and numbers out
// of range. Requires that only buffers that the shader reaches are in the program.
void AssignRegisters(Program& program, Diagnostics& diagnostics);

}  // namespace clipc::rules
