// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "tools/random/program.h"

// The places of the constants of a buffer, worked out a second time, from the text of Direct3D's
// rules ("Packing rules for constant variables") and without clipc's code: a mistake in
// ir/packing.cpp would be in the evaluator and in the GLSL alike, so that their values would agree.
namespace clipc::random {

// Spells out the `major` of each matrix in the structs, and returns them.
const Structs& WithMajors(Structs& structs, bool row_major);

struct Extent {
  int size = 0;             // bytes, up to the end of the last component
  bool starts_row = false;  // whether it begins at a multiple of 16
};
Extent ExtentOf(const Structs& structs, const Type& type, bool row_major);

// The byte of each component of each member in turn: elements, fields, matrices row after row.
std::vector<std::vector<std::uint32_t>> OffsetsOf(const Structs& structs,
                                                  const ConstantBuffer& buffer);

}  // namespace clipc::random
