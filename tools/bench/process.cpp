// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/bench/process.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/harness/timing.h"

extern char** environ;

namespace clipc::bench {

std::optional<Run> RunProcess(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  const auto start = std::chrono::steady_clock::now();
  pid_t pid = 0;
  const int failed = posix_spawn(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed) return std::nullopt;
  int status = 0;
  rusage usage{};
  wait4(pid, &status, 0, &usage);
  Run run;
  run.wall_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  const auto milliseconds = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  run.cpu_ms = milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
  run.peak_kib = usage.ru_maxrss;
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return run;
}

std::vector<std::vector<Run>> RunInTurn(const std::vector<std::vector<std::string>>& commands,
                                        int rounds) {
  std::vector<std::vector<Run>> results(commands.size());
  for (int round = -1; round < rounds; ++round) {  // round -1 warms the caches
    for (std::size_t i = 0; i < commands.size(); ++i) {
      const std::optional<Run> run = RunProcess(commands[i]);
      if (!run || run->status != 0) {
        std::fprintf(stderr, "%s failed\n", commands[i][0].c_str());
        std::exit(1);
      }
      if (round >= 0) results[i].push_back(*run);
    }
  }
  return results;
}

double MedianOf(const std::vector<Run>& runs, double Run::* field) {
  std::vector<double> values;
  for (const Run& run : runs) values.push_back(run.*field);
  return harness::Median(std::move(values));
}

}  // namespace clipc::bench
