// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "ir/program.h"

namespace clipc {

// Tries out, on the reference evaluator and with made-up constants, whether SV_Position is the
// input times matrices: whether it depends on no other input, and whether the middle of two
// vertices lands in the middle of their positions. Says what is against it, for a message; empty
// where nothing is, or where the shader cannot be run. Finds skinning, instances and waves; it
// cannot find what moves all vertices alike, which a matrix might do as well.
//
// Requires Form::kTyped and that `input` is a float3 or float4 input.
std::string WhyNotTimesMatrices(const ir::Program& program, ir::VarId input);

}  // namespace clipc
