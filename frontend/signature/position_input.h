// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "frontend/signature/names.h"

namespace clipc::signature {

// The input that carries `semantic`, for clip planes in the object's own space. Letters compare
// without case, and a semantic without an index has index 0: "POSITION0" is "position". Returns
// none after an error:
//
// - the entry point does not have such an input, or the input is not a float3 or float4;
// - the entry function writes it anywhere: assigns the parameter or field that carries it, a part
//   of it, or the struct around it, increments it, or passes it as an `out` or `inout` argument.
//   Then it is doubtful which of the two positions the planes are for.
//
// Warns if the position is more than the input times matrices (position_trial.h).
// Requires a checked program (Form::kResolved).
VarId CheckPositionInput(const Program& program, std::string_view semantic,
                         Diagnostics& diagnostics);

}  // namespace clipc::signature
