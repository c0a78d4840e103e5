// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/draw/compare.h"
#include "tools/draw/opengl/program.h"

namespace clipc::draw {

// Lets the draw call have all whole primitives of `size` vertices that the random ones give.
void TakePrimitives(const RandomInputs& random, int size, Inputs& inputs);
// A vertex shader that passes the inputs of `shader`, which reads vertices, on; adds their values
// to `inputs`, after TakePrimitives.
std::string PassOnText(const Version& version, const Shader& shader, const RandomInputs& random,
                       Inputs& inputs);

// Runs the text of a geometry shader after a vertex shader that passes the random vertices on, and
// returns its outputs `names` of all vertices that it emits. They are captured as points, in the
// order in which they are emitted.
std::vector<Captured> Emit(const std::string& geometry, std::span<const std::string> names,
                           const Trial& trial, Inputs inputs);

}  // namespace clipc::draw
