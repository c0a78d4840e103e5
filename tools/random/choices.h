// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "base/not_copied.h"
#include "tools/harness/random.h"

namespace clipc::random {

// A part of the choices that were drawn for one thing: a statement, an expression.
struct Span {
  std::size_t begin = 0, end = 0;
};

// A list of small numbers, written down as they are drawn, holds all that is random in a generated
// program. The same list gives the same program, and of every choice 0 is the simplest, so that a
// shorter list or one of smaller numbers gives a simpler program: that is how programs are reduced.
using ChoiceList = std::vector<std::uint32_t>;

// A source of choices, which draws a ChoiceList or gives one again.
class Choices {
 public:
  // Draws new numbers.
  explicit Choices(std::uint64_t seed) : random_(seed) {}
  // Gives the numbers of `list` again; after its end every choice is 0.
  explicit Choices(ChoiceList list) : random_(0), list_(std::move(list)), replays_(true) {}

  // A choice in [0, limit); 0 for a limit of 0.
  std::uint32_t Below(std::size_t limit);
  // A choice in [least, greatest].
  int Between(int least, int greatest);
  // A choice that is true in `percent` of 100 cases; false is the simple answer.
  bool Chance(std::uint32_t percent);
  // The index of one of the weights, each as likely as it is large. The first is the simplest.
  std::size_t Pick(std::initializer_list<std::uint32_t> weights);
  template <typename List>
  const auto& OneOf(const List& list) {
    return list[Below(std::size(list))];
  }

  // Whether the list is as long as lists may be: all further choices are 0.
  bool IsSpent() const { return drawn_.size() >= kMost; }

  // The numbers drawn, each below its limit, and the spans, the outer ones after the inner ones.
  const ChoiceList& drawn() const { return drawn_; }
  const std::vector<Span>& spans() const { return spans_; }

 private:
  friend class SpanOf;
  static constexpr std::size_t kMost = 6000;

  harness::Random random_;
  ChoiceList list_, drawn_;
  std::vector<Span> spans_;
  bool replays_ = false;
};

// A scope whose choices are noted as one span.
class SpanOf : NotCopied {
 public:
  explicit SpanOf(Choices& choices) : choices_(choices), begin_(choices.drawn_.size()) {}
  ~SpanOf();

 private:
  Choices& choices_;
  std::size_t begin_;
};

// Calls make(0), make(1) ... at most `most` times; each is a span of its own, so that a reducer can
// cut one out. `percent` is the chance that there is one more.
template <typename Make>
void Repeat(Choices& choices, int most, std::uint32_t percent, Make&& make) {
  for (int i = 0; i < most; ++i) {
    const SpanOf span(choices);
    if (!choices.Chance(percent)) return;
    make(i);
  }
}

}  // namespace clipc::random
