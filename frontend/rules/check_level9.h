// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/names.h"

namespace clipc::rules {

// Reports the uses of features that the vs_4_0_level_9_x profiles lack, each with its own message
// (fxc X4583 and its family; "Shader Model 2" limits of the 10Level9 documentation). Of those that
// Direct3D 9 lacks: bit operations (fxc X3535, "Bitwise operations not supported on target ps_3_0")
// and, under vs_1_1 and vs_2_0, loops that cannot be unrolled (X3511). Does nothing under other
// profiles. Requires a program without errors. The preshader of a shader in an effect computes
// what depends on uniforms alone.
void CheckLevel9(const Program& program, bool has_preshader, Diagnostics& diagnostics);

}  // namespace clipc::rules
