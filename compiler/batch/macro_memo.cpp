// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/batch/macro_memo.h"

#include <algorithm>

namespace clipc {
namespace {

// The values as one text: each after its length, so that no two lists give the same.
std::string KeyOf(const std::vector<std::size_t>& asked,
                  const std::vector<std::string_view>& values) {
  std::string key;
  for (const std::size_t index : asked) {
    key += std::to_string(values[index].size());
    key += ':';
    key += values[index];
  }
  return key;
}

}  // namespace

std::optional<std::size_t> MacroMemo::Find(const std::vector<std::string_view>& values) const {
  for (const Question& question : questions_) {
    const auto found = question.jobs.find(KeyOf(question.asked, values));
    if (found != question.jobs.end()) return found->second;
  }
  return std::nullopt;
}

void MacroMemo::Add(const std::vector<std::string_view>& values,
                    const std::vector<std::string>& used, std::size_t job) {
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (names_[i].find('(') != std::string::npos || std::ranges::binary_search(used, names_[i]))
      asked.push_back(i);
  }
  auto question = std::ranges::find(questions_, asked, &Question::asked);
  if (question == questions_.end()) {
    if (questions_.size() == kMaxQuestions) return;
    question = questions_.insert(question, {asked, {}});
  }
  question->jobs.emplace(KeyOf(question->asked, values), job);
}

}  // namespace clipc
