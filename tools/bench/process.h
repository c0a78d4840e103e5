// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>
#include <vector>

// Measurements of whole processes from outside, as the user sees them.
namespace clipc::bench {

struct Run {
  double wall_ms = 0;
  double cpu_ms = 0;  // user and system
  long peak_kib = 0;  // resident set
  int status = 0;     // exit status; 128 + n when killed by signal n
};
// Starts `command`, whose first word is the program's path, without its output, and waits for it.
// Returns none when it cannot start.
std::optional<Run> RunProcess(const std::vector<std::string>& command);

// Runs each command `rounds` times, in turn (A B C A B C ...), so that a drift of the machine's
// speed changes all alike. result[i] has the runs of commands[i]. Exits with a message when a
// command cannot start or fails.
std::vector<std::vector<Run>> RunInTurn(const std::vector<std::vector<std::string>>& commands,
                                        int rounds);

// The median of one number of the runs, such as &Run::cpu_ms.
double MedianOf(const std::vector<Run>& runs, double Run::* field);

}  // namespace clipc::bench
