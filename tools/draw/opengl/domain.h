// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/draw/compare.h"
#include "tools/draw/opengl/program.h"
#include "tools/harness/offscreen.h"

namespace clipc::draw {

// The points for which a domain shader runs, in their order: of patches that the random vertices
// make, as the driver tessellates them.
std::vector<DomainPoint> PointsOf(harness::OpenGl& opengl, const Shader& shader,
                                  const RandomInputs& random);

// Runs the text of a domain shader after a vertex and a hull shader that pass the random control
// points and constants on, and returns its outputs `names` for all points.
std::vector<Captured> Evaluate(const std::string& domain, std::span<const std::string> names,
                               const Trial& trial, Inputs inputs);

}  // namespace clipc::draw
