// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "ir/evaluate.h"
#include "ir/program.h"

namespace clipc::draw {

// What a shader reads, at random; equal seeds give equal values on every machine. Floats lie in [-2, 2], one in four is a
// whole number, so that comparisons and exact zeros occur, and no result is large enough to hide the errors of another.
struct RandomInputs {
  std::vector<std::vector<ir::IoBits>> vertices;    // by vertex, then by index into Program::inputs
  std::vector<std::vector<std::uint8_t>> cbuffers;  // by CbufferId
};
struct RandomOptions {
  std::uint32_t seed = 1;
  int vertices = 64;
  int instances = 1;
  int first_vertex = 0, base_instance = 0;  // of the draw call
  int least_int = -4, greatest_int = 7;  // loop counts and array indices must stay small
};

// vertices[i * instances..]: instance after instance, each with the same attributes, as a draw call runs them.
RandomInputs MakeRandomInputs(const ir::Program& program, const RandomOptions& options);

}  // namespace clipc::draw
