// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/choices.h"

namespace clipc::random {

std::uint32_t Choices::Below(std::size_t limit) {
  if (limit <= 1 || IsSpent()) return 0;
  std::uint32_t choice = 0;
  if (!replays_) {
    choice = random_.Below(static_cast<std::uint32_t>(limit));
  } else if (drawn_.size() < list_.size()) {
    choice = list_[drawn_.size()] % limit;
  }
  drawn_.push_back(choice);
  return choice;
}

int Choices::Between(int least, int greatest) {
  return least + static_cast<int>(Below(static_cast<std::uint32_t>(greatest - least + 1)));
}

bool Choices::Chance(std::uint32_t percent) { return Below(100) >= 100 - percent; }

std::size_t Choices::Pick(std::initializer_list<std::uint32_t> weights) {
  std::uint32_t sum = 0;
  for (const std::uint32_t weight : weights) sum += weight;
  std::uint32_t left = Below(sum);
  std::size_t index = 0;
  for (const std::uint32_t weight : weights) {
    if (left < weight) return index;
    left -= weight;
    ++index;
  }
  return 0;
}

SpanOf::~SpanOf() {
  if (choices_.drawn_.size() > begin_) choices_.spans_.push_back({begin_, choices_.drawn_.size()});
}

}  // namespace clipc::random
