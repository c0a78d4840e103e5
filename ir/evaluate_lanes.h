// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "ir/evaluate_math.h"

// How the pixels of a quad, and the lanes of a wave, know of each other. Each runs alone and notes
// the operands of which another may ask; then all run again with what was noted, until they note
// the same as before. The first operand that depends on no other lane is right after one run, what
// depends on that one after two, and so on, so that this ends.
namespace clipc::ir {

// The number of the calls and iterations inside of which an expression is evaluated, where `outer`
// is that of the ones around the innermost, and `inner` the innermost call or iteration itself.
inline std::uint64_t FlowIn(std::uint64_t outer, std::uint64_t inner) {
  return ((outer << 25 | outer >> 39) ^ (inner + 1)) * 0x9e3779b97f4a7c15u;
}

// The operands that each lane noted: the same place in the program within the same iterations has
// the same key in all lanes.
using LaneKey = std::pair<std::uint64_t, std::uint32_t>;
using LaneNotes = std::vector<std::map<LaneKey, std::vector<Word>>>;

// The lanes beside one lane.
class Lanes {
 public:
  // Lane number `lane` knows what all noted before, and notes its own operands in `notes`.
  Lanes(std::size_t lane, const LaneNotes& before, LaneNotes& notes)
      : lane_(lane), before_(before), notes_(notes) {}

  // The operands of all lanes; null for a lane that does not come by.
  using Operands = std::vector<const Word*>;
  Operands Ask(LaneKey key, std::span<const Word> own);

  std::size_t lane() const { return lane_; }

 private:
  std::size_t lane_;
  const LaneNotes& before_;
  LaneNotes& notes_;
};

}  // namespace clipc::ir
