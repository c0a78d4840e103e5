// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/arena.h"
#include "base/id.h"

namespace clipc {

// An interned identifier. Within one Names, two Names are equal if their texts are.
using Name = Id<std::string>;

// The identifiers of one translation unit.
class Names {
 public:
  Name Intern(std::string_view text) {
    if (texts_.size() >= slots_.size() / 2) Grow();
    const std::size_t slot = SlotOf(text);
    if (!slots_[slot]) slots_[slot] = texts_.Add(std::string(text));
    return slots_[slot];
  }
  std::string_view operator[](Name name) const {
    return name ? std::string_view(texts_[name]) : "";
  }
  std::uint32_t size() const { return texts_.size(); }

 private:
  // The slot of `text`, or the free slot that it would take. At least half of the slots are free.
  std::size_t SlotOf(std::string_view text) const {
    std::size_t slot = std::hash<std::string_view>()(text) & (slots_.size() - 1);
    while (slots_[slot] && texts_[slots_[slot]] != text) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }
  void Grow() {
    slots_.assign(slots_.empty() ? 256 : 2 * slots_.size(), Name{});
    for (const Name name : texts_.ids()) slots_[SlotOf(texts_[name])] = name;
  }

  Arena<std::string> texts_;
  std::vector<Name> slots_;  // a hash table of Names; its size is a power of two
};

}  // namespace clipc
