// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "ir/program.h"

namespace clipc {

// Gives every cbuffer and resource without a written register its number: used buffers take the
// free slots in order of declaration, $Globals first, $Params last; textures and samplers likewise.
// Reports two explicit bindings of one register, and numbers out of range. Requires that only
// reached buffers are in the program.
void AssignRegisters(ir::Program& program, Diagnostics& diagnostics);

}  // namespace clipc
