// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "ir/program.h"

namespace clipc {

// The number of matrices that the shader multiplies the position by, one after the other: the most
// on any way from the inputs to SV_Position. 1 for mul(v, world_view_projection), 2 for mul(mul(v,
// world), view_projection) and for mul(v, mul(world, view_projection)), 0 where the position is not
// multiplied. A product of anything with a row of a matrix counts as one with the matrix. Returns
// nullopt where the number cannot be told: a dot product of four numbers with what is not a matrix,
// which may be one by hand; products in a loop whose number depends on values; a shader that is too
// large to follow; no position. Requires Form::kTyped.
std::optional<int> CountPositionMatrices(const ir::Program& program);

}  // namespace clipc
