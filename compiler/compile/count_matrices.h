// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>

#include "ir/program.h"

namespace clipc {

// What the shader multiplies the position by. Requires Form::kResolved.
struct PositionMatrices {
  // The number of matrices, one after the other: the most on any way from the inputs to
  // SV_Position. 1 for mul(v, world_view_projection), 2 for mul(mul(v, world), view_projection) and
  // for mul(v, mul(world, view_projection)), 0 where the position is not multiplied. A product of
  // anything with a row of a matrix counts as one with the matrix. None where the number cannot be
  // told: a dot product of four numbers with what is not a matrix, which may be one by hand;
  // products in a loop whose number depends on values; a shader that is too large to follow; no
  // position.
  std::optional<int> count;
  // Which matrices they are, and the order in which they are multiplied: "mul(mul(v, world),
  // view_projection)", where v stands for what is not a matrix. None where control or values decide
  // it, where a matrix has no name, and where it is not mul() that multiplies.
  std::optional<std::string> product;
};
PositionMatrices FollowPosition(const ir::Program& program);

}  // namespace clipc
