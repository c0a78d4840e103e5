// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ir/evaluate_lanes.h"

// How the threads of a group run in step, from one wait for the group to the next. A phase is what
// lies between two waits. In each phase every thread runs once, from its beginning: what it ran in
// phases before it repeats, with what it read then and without its stores, and stops where it waits
// next. So all stores of a phase come before all reads of the next, and no thread is kept alive.
// Where lanes of a wave ask each other, the threads of a wave run a phase again and again as the
// pixels of a quad do (ir/evaluate_lanes.h), each time with the memory that it began with.
namespace clipc::ir {

// The memory that a group shares, a word for each component, and who used it in the phase.
class SharedWords {
 public:
  enum class Use : std::uint8_t { kRead, kWrite, kAtomic };

  // The first thread gives the values that nobody wrote.
  void Start(std::span<const Word> words);
  Word& At(std::uint32_t word) { return words_[word]; }
  // Notes that a thread uses the word. Two threads race for it if one writes it, and not both by
  // atomic operations.
  void Note(std::uint32_t thread, std::uint32_t word, Use use);
  void BeginPhase() { users_.assign(users_.size(), {}); }
  bool has_race() const { return has_race_; }

 private:
  // By Use: the number of the thread plus 1; kSeveral.
  struct Users {
    std::uint32_t of[3] = {};
  };
  static constexpr std::uint32_t kSeveral = ~0u;

  std::vector<Word> words_;
  std::vector<Users> users_;
  bool has_race_ = false;
};

// What a thread read in the phases before, and the call at which it waits.
struct ThreadPast {
  std::vector<Word> reads;
  ExprId waits_at;  // none: it has ended
};

// A thread in one phase.
class GroupThread {
 public:
  GroupThread(std::uint32_t number, std::size_t phase, SharedWords& shared, ThreadPast& past,
              Lanes& lanes)
      : number_(number), phase_(phase), shared_(shared), past_(past), lanes_(lanes) {
    past.waits_at = {};
  }

  Lanes& lanes() const { return lanes_; }

  void Start(std::span<const Word> words) { shared_.Start(words); }
  Word Read(std::uint32_t word, bool is_atomic);
  void Write(std::uint32_t word, Word value, bool is_atomic);
  // Comes to a wait; returns false if the thread stops there.
  bool Wait(ExprId call);
  // Fills in what an access to an object gave before; returns false if the thread has yet to do it.
  // Then Keep() takes what it gives.
  bool Repeats(std::span<Word> result);
  void Keep(std::span<const Word> result);

 private:
  bool IsLive() const { return waits_ == phase_; }
  Word Next() { return next_ < past_.reads.size() ? past_.reads[next_++] : 0; }

  const std::uint32_t number_;
  const std::size_t phase_;
  SharedWords& shared_;
  ThreadPast& past_;
  Lanes& lanes_;
  std::size_t waits_ = 0, next_ = 0;
};

}  // namespace clipc::ir
