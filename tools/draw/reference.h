// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/draw/build.h"
#include "tools/draw/random_inputs.h"

namespace clipc::draw {

// The values that one output of the written shader must have.
struct Expected {
  std::string name;  // in the GLSL
  ir::Scalar kind;   // kFloat, kInt or kUint
  int components;    // of a vector, or elements of an array
  Words words;       // of vertex 0, then of vertex 1, ...
  std::vector<double>
      numbers;             // beside `words`: computed in double, to tell how far rounding may go
  std::vector<bool> open;  // beside `words`: whether HLSL leaves it undefined, so that any is right
};

// Runs the checked program, before any pass, in the reference evaluator. The outputs that passes
// add are computed here from their definition: distances as dot(SV_Position, plane), or as the
// plane space says, with the plane taken from the cbuffer's bytes; then y and z of the position. Of
// a compute shader, the memory that it may write.
std::vector<Expected> MakeExpected(const Shader& shader, const BuildOptions& options,
                                   const RandomInputs& inputs);

// The number of points, lines or triangles in the strips that a geometry shader emits, which end at
// RestartStrip too; none if a strip has fewer vertices than one of them. Throws DrawError where the
// evaluator stops.
std::optional<std::size_t> CountPrimitives(const Shader& shader, const RandomInputs& inputs);

}  // namespace clipc::draw
