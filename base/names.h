// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>

#include "base/id.h"

namespace clipc {

// An interned identifier; equal text, equal Name (within one Names).
using Name = Id<std::string>;

// The identifiers of one translation unit.
class Names {
 public:
  Name Intern(std::string_view text) {
    if (auto found = by_text_.find(text); found != by_text_.end()) return found->second;
    Name name{static_cast<std::uint32_t>(texts_.size())};
    by_text_.emplace(texts_.emplace_back(text), name);
    return name;
  }
  std::string_view operator[](Name name) const { return name ? std::string_view(texts_[name.index]) : ""; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(texts_.size()); }

 private:
  std::deque<std::string> texts_;  // a deque keeps the keys of by_text_ in place
  std::unordered_map<std::string_view, Name> by_text_;
};

}  // namespace clipc
