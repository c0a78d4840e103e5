// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/name.h"

#include <cstddef>
#include <functional>

namespace clipc {

Name Names::Intern(std::string_view text) {
  if (texts_.size() >= slots_.size() / 2) Grow();
  const std::size_t slot = SlotOf(text);
  if (!slots_[slot]) slots_[slot] = texts_.Make(text);
  return slots_[slot];
}

std::size_t Names::SlotOf(std::string_view text) const {
  std::size_t slot = std::hash<std::string_view>()(text) & (slots_.size() - 1);
  while (slots_[slot] && texts_[slots_[slot]] != text) slot = (slot + 1) & (slots_.size() - 1);
  return slot;
}

void Names::Grow() {
  slots_.assign(slots_.empty() ? 256 : 2 * slots_.size(), Name{});
  for (const Name name : texts_.ids()) slots_[SlotOf(texts_[name])] = name;
}

}  // namespace clipc
