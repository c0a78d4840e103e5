// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/evaluate_group.h"

namespace clipc::ir {

void SharedWords::Start(std::span<const Word> words) {
  if (!words_.empty() || words.empty()) return;
  words_.assign(words.begin(), words.end());
  users_.resize(words.size());
}

void SharedWords::Note(std::uint32_t thread, std::uint32_t word, Use use) {
  Users& users = users_[word];
  const auto others_did = [&](Use other) {
    const std::uint32_t user = users.of[static_cast<std::size_t>(other)];
    return user != 0 && user != thread + 1;
  };
  has_race_ |= (use != Use::kRead && others_did(Use::kRead)) || others_did(Use::kWrite) ||
               (use != Use::kAtomic && others_did(Use::kAtomic));
  std::uint32_t& user = users.of[static_cast<std::size_t>(use)];
  user = user == 0 || user == thread + 1 ? thread + 1 : kSeveral;
}

Word GroupThread::Read(std::uint32_t word, bool is_atomic) {
  if (!IsLive()) return Next();
  using enum SharedWords::Use;
  shared_.Note(number_, word, is_atomic ? kAtomic : kRead);
  past_.reads.push_back(shared_.At(word));
  ++next_;
  return shared_.At(word);
}

void GroupThread::Write(std::uint32_t word, Word value, bool is_atomic) {
  if (!IsLive()) return;
  using enum SharedWords::Use;
  shared_.Note(number_, word, is_atomic ? kAtomic : kWrite);
  shared_.At(word) = value;
}

bool GroupThread::Wait(ExprId call) {
  if (waits_ > phase_) return false;
  if (IsLive()) past_.waits_at = call;
  return ++waits_ <= phase_;
}

bool GroupThread::Repeats(std::span<Word> result) {
  if (IsLive()) return false;
  for (Word& word : result) word = Next();
  return true;
}

void GroupThread::Keep(std::span<const Word> result) {
  past_.reads.insert(past_.reads.end(), result.begin(), result.end());
  next_ += result.size();
}

}  // namespace clipc::ir
