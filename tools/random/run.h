// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>

#include "tools/random/features.h"

namespace clipc::random {

struct RunOptions {
  std::uint64_t seed = 1;   // the seed of the first program; each further one has the next
  std::uint64_t count = 0;  // programs; 0: no limit
  double seconds = 0;       // 0: no limit
  std::string out = "random-failures";
  std::string repeat;         // a choices.txt, instead of new programs
  std::string feature_flags;  // as given, to repeat them
  Features features;
  bool draws = true, reduces = true, prints = false, stops = false;
};

// Generates programs, judges each, reduces and writes those that fail, and prints a summary.
// Returns the exit code: 0 where none fails.
int RunPrograms(const RunOptions& options);

}  // namespace clipc::random
