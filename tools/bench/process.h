// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>
#include <vector>

// Whole processes, measured from outside as the user meets them.
namespace clipc::bench {

struct Run {
  double wall_ms = 0;
  double cpu_ms = 0;  // user and system
  long peak_kib = 0;  // resident set
  int status = 0;     // exit status; 128 + n when killed by signal n
};
// Starts `command` (found by its path) with its output thrown away and waits for it; nothing when
// it cannot start.
std::optional<Run> RunProcess(const std::vector<std::string>& command);

// Each command `rounds` times, in turn (A B C A B C ...), so that a drift of the machine's speed
// hits all alike. result[i] are command i's runs. Exits with a message when one cannot start or
// fails.
std::vector<std::vector<Run>> RunInTurn(const std::vector<std::vector<std::string>>& commands,
                                        int rounds);

double MedianWall(const std::vector<Run>& runs);
double MedianCpu(const std::vector<Run>& runs);
double Median(std::vector<double> values);

}  // namespace clipc::bench
