// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <span>

#include "ir/evaluate_lanes.h"

// The pixels of a quad are lanes that run in step.
namespace clipc::ir {

// The neighbours of one pixel.
class Neighbours : public Lanes {
 public:
  using Lanes::Lanes;

  // The operands of all four pixels; none where one of them does not come by.
  std::optional<Operands> AskAll(LaneKey key, std::span<const Word> own);

  // The pixels whose difference, second - first, is the derivative of this pixel along x or y.
  std::size_t FirstAlongX() const { return lane() & 2; }
  std::size_t SecondAlongX() const { return lane() | 1; }
  std::size_t FirstAlongY() const { return lane() & 1; }
  std::size_t SecondAlongY() const { return lane() | 2; }
};

}  // namespace clipc::ir
