// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <vector>

#include "tools/random/choices.h"

namespace clipc::random {

// The choices of a list that a program really draws, and their spans.
struct Made {
  ChoiceList drawn;
  std::vector<Span> spans;
};

struct Reduction {
  std::function<Made(const ChoiceList&)> make;
  // Whether the program of these choices still shows the fault.
  std::function<bool(const ChoiceList&)> fails;
  int most_tries = 1500;
};

// A list for which `fails` holds, shorter than `list` where a shorter one was found, and otherwise
// of smaller numbers. Spans are cut out, replaced by spans in them, or made of zeros; then runs of
// numbers; then single numbers become smaller. This is delta debugging on what was drawn: each list
// is a program without errors.
ChoiceList Reduce(const ChoiceList& list, const Reduction& reduction);

}  // namespace clipc::random
