// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/arena.h"
#include "base/id.h"
#include "base/kept_blocks.h"

namespace clipc {

// An interned identifier. Within one Names, two Names are equal if their texts are.
using Name = Id<std::string>;

// The identifiers of one translation unit.
class Names {
 public:
  Name Intern(std::string_view text);
  std::string_view operator[](Name name) const {
    return name ? std::string_view(texts_[name]) : "";
  }
  std::uint32_t size() const { return texts_.size(); }

 private:
  // The slot of `text`, or the free slot that it would take. At least half of the slots are free.
  std::size_t SlotOf(std::string_view text) const;
  void Grow();

  Arena<std::string> texts_;
  KeptVector<Name> slots_;  // a hash table of Names; its size is a power of two
};

}  // namespace clipc
