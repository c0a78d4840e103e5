// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "tools/draw/build.h"
#include "tools/draw/random_inputs.h"

namespace clipc::draw {

// What one output of the written shader must be.
struct Expected {
  std::string name;                  // in the GLSL
  ir::Scalar kind;                   // kFloat, kInt or kUint
  int components;                    // of a vector, or elements of an array
  std::vector<std::uint32_t> words;  // of vertex 0, then of vertex 1, ...
  std::vector<double>
      numbers;             // the same, computed in double: a yardstick for what rounding may change
  std::vector<bool> open;  // the same: depends on what HLSL leaves undefined; anything is right
};

// By the reference evaluator from the checked program, before any pass. What the passes add is
// computed here from their definition: distances as dot(SV_Position, plane), or what the plane
// space asks for, with the plane taken from the cbuffer's bytes, then y and z.
std::vector<Expected> MakeExpected(const Shader& shader, const BuildOptions& options,
                                   const RandomInputs& inputs);

}  // namespace clipc::draw
