// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/batch/batch_errors.h"

#include <fmt/format.h>

namespace clipc {
namespace {

std::string TextOf(const Message& message) {
  if (message.place.file.empty()) return message.text;
  return fmt::format("{}:{}:{}: {}", message.place.file, message.place.line, message.place.column,
                     message.text);
}

}  // namespace

bool BatchErrors::AreNew(const std::vector<Message>& messages) {
  bool are_new = false;
  for (const Message& message : messages) are_new |= seen_.insert(TextOf(message)).second;
  return are_new;
}

void BatchErrors::Count(const std::vector<Message>& errors) {
  for (const Message& error : errors) {
    const auto [place, is_new] = places_.emplace(TextOf(error), counts_.size());
    if (is_new) counts_.emplace_back(place->first, 0);
    ++counts_[place->second].second;
  }
}

std::vector<std::string> BatchErrors::Shared() const {
  std::vector<std::string> lines;
  for (const auto& [text, count] : counts_) {
    if (count > 1) lines.push_back(fmt::format("{} permutations stop at {}", count, text));
  }
  return lines;
}

}  // namespace clipc
