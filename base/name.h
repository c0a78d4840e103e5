// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/id.h"

namespace clipc {

// An interned identifier. Within one Names, two Names are equal if their texts are.
using Name = Id<std::string>;

// The identifiers of one translation unit.
class Names {
 public:
  Name Intern(std::string_view text) {
    if (2 * texts_.size() >= slots_.size()) Grow();
    const std::size_t slot = SlotOf(text);
    if (!slots_[slot]) {
      slots_[slot] = Name{size()};
      texts_.emplace_back(text);
    }
    return slots_[slot];
  }
  std::string_view operator[](Name name) const {
    return name ? std::string_view(texts_[name.index]) : "";
  }
  std::uint32_t size() const { return static_cast<std::uint32_t>(texts_.size()); }

 private:
  // The slot of `text`, or the free slot that it would take. At least half of the slots are free.
  std::size_t SlotOf(std::string_view text) const {
    std::size_t slot = std::hash<std::string_view>()(text) & (slots_.size() - 1);
    while (slots_[slot] && texts_[slots_[slot].index] != text)
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }
  void Grow() {
    slots_.assign(slots_.empty() ? 256 : 2 * slots_.size(), Name{});
    for (std::uint32_t i = 0; i < size(); ++i) slots_[SlotOf(texts_[i])] = Name{i};
  }

  std::deque<std::string> texts_;  // a deque keeps the texts in place
  std::vector<Name> slots_;        // a hash table of Names; its size is a power of two
};

}  // namespace clipc
