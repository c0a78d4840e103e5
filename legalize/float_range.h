// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ir/program.h"

namespace clipc::legalize {

// What the components of an expression lie between, all of which are finite.
struct FloatRange {
  double low = 0, high = 0;
  bool may_be_nan = false;  // a component may be NaN instead
};

// Knows the bounds of constants, of saturate, clamp and frac, of a pixel's place on the screen, of
// integers, of local variables and their fields that only a declaration or the head of a `for`
// gives a value, and of what arithmetic and rounding make of them.
class FloatRanges {
 public:
  // The functions must keep their variables and writes while this lives. Values may be replaced by
  // equal ones.
  explicit FloatRanges(const ir::Program& program) : program_(program) {}

  // The bounds of a number or vector of floats or integers; std::nullopt where it may be anything.
  std::optional<FloatRange> Of(ir::ExprId expr);

 private:
  bool IsKnown(ir::VarId var);
  bool MayTell(ir::VarId var);
  void FindLocals();
  ir::ExprId ValueOf(const ir::FieldRef& node);
  void FindCounter(const ir::For& loop, const std::vector<std::uint32_t>& writes);

  const ir::Program& program_;
  std::vector<bool> may_tell_;                     // by VarId, once asked for
  bool has_locals_ = false;                        // found for the first that is asked for
  std::vector<std::optional<FloatRange>> locals_;  // by VarId
  std::vector<ir::ExprId> values_;                 // of structs, by VarId
  std::vector<std::pair<ir::VarId, std::uint32_t>> written_fields_;
};

}  // namespace clipc::legalize
