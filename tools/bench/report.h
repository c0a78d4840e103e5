// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdio>

namespace clipc::bench {

inline int g_missed = 0;    // the number of limits that were missed
inline double g_slack = 1;  // what each limit is multiplied by: --slack

// Prints a row of the table: what was measured, beside its limit.
inline void Report(const char* what, double value, const char* unit, double limit) {
  limit *= g_slack;
  const bool holds = value <= limit;
  g_missed += !holds;
  std::printf("| %s | %.3g %s | at most %.3g %s | %s |\n", what, value, unit, limit, unit,
              holds ? "holds" : "**missed**");
  std::fflush(stdout);
}

}  // namespace clipc::bench
