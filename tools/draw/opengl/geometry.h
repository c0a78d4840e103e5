// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/draw/compare.h"
#include "tools/draw/opengl/program.h"
#include "tools/draw/pass_on.h"

namespace clipc::draw {

// The shaders that pass the random vertices on to the shader, which reads several. Lets the draw
// call have those of whole primitives or patches, and adds their values to `inputs`.
PassedOn PassOnInto(Inputs& inputs, const Version& version, const Shader& shader,
                    const RandomInputs& random);

// Runs the text of a geometry shader after a vertex shader that passes the random vertices on, and
// returns its outputs `names` of all vertices that it emits. They are captured as points, in the
// order in which they are emitted.
std::vector<Captured> Emit(const std::string& geometry, std::span<const std::string> names,
                           const Trial& trial, Inputs inputs);

}  // namespace clipc::draw
