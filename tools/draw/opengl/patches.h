// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "tools/draw/compare.h"
#include "tools/draw/opengl/program.h"

namespace clipc::draw {

// Runs the text of a hull shader after a vertex shader that passes the random vertices on, and
// before one that takes its outputs to where they are captured. Returns the outputs of the control
// points, patch after patch; what a patch has once stands with each of its points. `names` are
// some of the shader's outputs.
std::vector<Captured> MakePatches(const std::string& hull, const std::vector<std::string>& names,
                                  const Trial& trial, Inputs inputs);

}  // namespace clipc::draw
