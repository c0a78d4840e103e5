// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/name.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace clipc {
namespace {

std::uint64_t Load(const char* bytes, std::size_t count) {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes, count);
  return value;
}

// A hash of few steps, as most names are short.
std::size_t HashOf(std::string_view text) {
  constexpr std::uint64_t kFactor = 0x9E3779B97F4A7C15u;
  const char* at = text.data();
  std::size_t left = text.size();
  std::uint64_t hash = left;
  const auto add = [&](std::uint64_t value) {
    hash = (hash ^ value) * kFactor;
    hash ^= hash >> 32;
  };
  for (; left > 8; left -= 8, at += 8) add(Load(at, 8));
  // The rest in one step, the bytes in the middle of it twice.
  if (left >= 4)
    add(Load(at, 4) | Load(at + left - 4, 4) << 32);
  else if (left > 0)
    add(Load(at, 1) | Load(at + left / 2, 1) << 8 | Load(at + left - 1, 1) << 16);
  return hash;
}

}  // namespace

Name Names::Intern(std::string_view text) {
  if (texts_.size() >= slots_.size() / 2) Grow();
  const std::size_t slot = SlotOf(text);
  if (!slots_[slot]) slots_[slot] = texts_.Make(text);
  return slots_[slot];
}

std::size_t Names::SlotOf(std::string_view text) const {
  std::size_t slot = HashOf(text) & (slots_.size() - 1);
  while (slots_[slot] && texts_[slots_[slot]] != text) slot = (slot + 1) & (slots_.size() - 1);
  return slot;
}

void Names::Grow() {
  slots_.assign(slots_.empty() ? 256 : 2 * slots_.size(), Name{});
  for (const Name name : texts_.ids()) slots_[SlotOf(texts_[name])] = name;
}

}  // namespace clipc
