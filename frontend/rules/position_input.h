// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "base/diagnostics.h"
#include "ir/program.h"

namespace clipc {

// The input that carries `semantic` ("POSITION0", "position": letters in any case, no index is 0),
// for clip planes in the object's own space. None after an error:
//
// - the entry point has no such input, or it is no float3 or float4;
// - the entry function writes it anywhere: assigns the parameter or field that carries it, a part
// of it, or the struct
//   around it, increments it, or passes it as an `out` or `inout` argument. Then it is doubtful
//   which of the two positions the planes are for.
//
// Warns where the position turns out to be more than the input times matrices (position_trial.h).
// Requires a checked program (Form::kTyped).
ir::VarId CheckPositionInput(const ir::Program& program, std::string_view semantic,
                             Diagnostics& diagnostics);

}  // namespace clipc
