// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>

#include "ir/program.h"

namespace clipc::legalize {

// A number that the program holds as a literal, as ir::Literal holds it.
struct Constant {
  std::uint64_t bits;
  ir::Scalar kind;
};
// Returns the number in every component of `expr`, if it is a zero, a literal, or a conversion, a
// splat or a negation of floats of such an expression; otherwise none.
std::optional<Constant> ConstantOf(const ir::Program& program, ir::ExprId expr);
// Whether both numbers are known, and the first is the smaller one.
bool AreInOrder(const std::optional<Constant>& low, const std::optional<Constant>& high);

}  // namespace clipc::legalize
