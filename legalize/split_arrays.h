// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "ir/program.h"
#include "legalize/needs.h"

// Arrays of textures, samplers and buffers whose elements become resources of their own, as
// registers of Direct3D are: arrays of samplers for OpenGL, which combines each sampler with a
// texture, and all arrays for dxc's -fspv-flatten-resource-arrays.
namespace clipc::legalize {

// The number of elements, in all dimensions, that become resources if literals name them: those of
// an array of a known and not too large size, without counters. 0 for every other variable.
std::uint32_t SplitCount(const ir::Program& program, ArraySplit split, ir::VarId var);

// The element of such an array that an expression names by literals, with its number among those of
// all dimensions; no array for every other expression.
struct ArrayElement {
  ir::VarId array;
  std::uint32_t number = 0;
};
ArrayElement SplitElementAt(const ir::Program& program, ArraySplit split, ir::ExprId expr);

}  // namespace clipc::legalize
