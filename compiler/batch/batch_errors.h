// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "compiler/compile/message.h"

namespace clipc {

// The messages of a batch: a line that permutations share has the same error in each of them.
class BatchErrors {
 public:
  // Whether one of the messages has not been here before.
  bool AreNew(const std::vector<Message>& messages);
  // Counts a permutation that has these errors.
  void Count(const std::vector<Message>& errors);
  // A line for each error of several permutations, in the order in which they came.
  std::vector<std::string> Shared() const;

 private:
  std::unordered_set<std::string> seen_;
  std::unordered_map<std::string, std::size_t> places_;  // in counts_
  std::vector<std::pair<std::string, std::size_t>> counts_;
};

}  // namespace clipc
