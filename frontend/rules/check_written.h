// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/names.h"

namespace clipc::rules {

// Reports what the shader reads, or leaves to the next stage, without having written it: local
// variables (fxc X4000, a warning), outputs (X3578, a warning: fxc compiles
// ContactHardeningShadows11.hlsl of the DirectX SDK, whose f4SMC nothing writes, and says "Output
// value 'o1' is not completely initialized" of an out parameter of the entry function, in messages
// that 3Dmigoto wrote down), out parameters of other functions (X3508, an error) and the position
// (X4580; dxc's validator: "Not all elements of SV_Position were written").
//
// A component counts as never written when no path to the place writes it, so that a variable that
// one branch writes is not reported; of outputs every path is asked. What an index that
// is not constant may choose, an argument of an inout parameter, and a part of a variable with more
// than 64 parts, which is taken for the whole, count as written. A loop may have run before, and
// runs at least once. Outputs that are never written are marked. Requires a program without errors;
// a walk of each function, once.
void CheckWritten(Program& program, Diagnostics& diagnostics);

}  // namespace clipc::rules
