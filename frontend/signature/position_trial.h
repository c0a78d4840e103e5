// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "frontend/signature/names.h"

namespace clipc::signature {

// Tries out, on the reference evaluator and with made-up constants, whether SV_Position is the
// input times matrices: whether it depends on no other input, and whether the middle of two
// vertices is drawn in the middle of their positions. Returns the reason against it, for a message;
// empty if there is none, or if the shader cannot be run. The trial finds skinning, instances
// and waves. It cannot find a change that moves all vertices alike, as a matrix might too.
//
// Requires Form::kResolved and that `input` is a float3 or float4 input.
std::string WhyNotTimesMatrices(const Program& program, VarId input);

}  // namespace clipc::signature
