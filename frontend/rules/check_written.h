// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/rules.h"

namespace clipc::rules {

// Reports what the shader reads, or leaves to the next stage, without having written it: local
// variables and outputs (fxc X4000, a warning: it compiles ContactHardeningShadows11.hlsl of the
// DirectX SDK, whose f4SMC nothing writes), out parameters (X3508) and the position (X4580; dxc's
// validator: "Not all elements of SV_Position were written").
//
// A component counts as never written when no path to the place writes it, so that a variable that
// one branch writes is not reported; of outputs every path is asked. What an index that
// is not constant may choose, an argument of an inout parameter, and a part of a variable with more
// than 64 parts, which is taken for the whole, count as written. A loop may have run before, and
// runs at least once. Outputs that are never written are marked. Requires a program without errors;
// a walk of each function, once.
void CheckWritten(Program& program, Diagnostics& diagnostics);

}  // namespace clipc::rules
