// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/evaluate_lanes.h"

namespace clipc::ir {

Lanes::Operands Lanes::Ask(LaneKey key, std::span<const Word> own) {
  const auto noted = notes_[lane_].emplace(key, std::vector<Word>(own.begin(), own.end())).first;
  Operands operands(before_.size());
  for (std::size_t i = 0; i < before_.size(); ++i) {
    const auto found = before_[i].find(key);
    if (found != before_[i].end()) operands[i] = found->second.data();
  }
  operands[lane_] = noted->second.data();
  return operands;
}

}  // namespace clipc::ir
