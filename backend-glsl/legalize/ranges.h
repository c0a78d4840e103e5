// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "ir/program.h"

namespace clipc::glsl {

// The least and the greatest value of an expression's components. A value whose range is known at
// both ends is not NaN.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();

  bool IsKnown() const { return least > -kLimit && most < kLimit; }
  bool IsWithin(double low, double high) const { return least >= low && most <= high; }

  // The limit of a known range: sums and products of ranges within it stay finite in 32 bits, so
  // that none is NaN.
  static constexpr double kLimit = 1e18;
};

// Bounds the values of expressions of numbers by their operators and constants. Inputs, uniforms
// and variables may have any value. The bounds of a constant are found once, so that constants that
// name each other cost no more than their text.
class Ranges {
 public:
  // The program may grow while this lives; the values of its constants stay as they are.
  explicit Ranges(const ir::Program& program) : program_(program) {}

  Range Of(ir::ExprId expr);

 private:
  friend class RangeFinder;
  const ir::Program& program_;
  std::vector<std::optional<Range>> of_constants_;  // by VarId
};

}  // namespace clipc::glsl
