// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>

#include <sys/wait.h>
#include <unistd.h>

#include "tools/harness/offscreen.h"
#include "tools/values/run.h"

namespace clipc::values {
namespace {

// A record is a line, and has the first line of a message alone.
std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

// Runs the file in the child, which ends here.
[[noreturn]] void RunChild(const std::string& text, const Family& family, int output) {
  std::FILE* file = fdopen(output, "w");
  const auto write = [&](const std::string& record) {
    std::fputs((record + "\n").c_str(), file);
    std::fflush(file);
  };
  const auto number = [](auto value) { return std::to_string(static_cast<int>(value)) + " "; };
  try {
    const harness::OpenGl opengl(harness::Api::kCore);
    RunFile(text, family,
            {[&](const Probe& probe) {
               write("probe " + number(probe.verdict) + number(probe.line) + FirstLine(probe.why));
             },
             [&](const Acceptance& shader) {
               write("shader " + number(shader.line) + number(shader.model) +
                     number(shader.is_expected) + number(shader.is_accepted) +
                     FirstLine(shader.why));
             }});
  } catch (const std::exception& error) {
    write("probe " + number(Verdict::kNotDrawn) + "0 " + FirstLine(error.what()));
  }
  std::_Exit(0);
}

}  // namespace

FileResult RunIsolated(const std::string& text, const Family& family) {
  int ends[2];
  if (pipe(ends) != 0) throw harness::DrawError("no pipe");
  const pid_t child = fork();
  if (child < 0) throw harness::DrawError("no process");
  if (child == 0) {
    close(ends[0]);
    RunChild(text, family, ends[1]);
  }
  close(ends[1]);
  std::string records;
  char part[4096];
  for (ssize_t size = 0; (size = read(ends[0], part, sizeof part)) > 0;)
    records.append(part, static_cast<std::size_t>(size));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);

  FileResult result;
  std::istringstream lines(records);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream record(line);
    std::string kind;
    record >> kind;
    std::string* why = nullptr;
    if (kind == "probe") {
      int verdict = 0;
      Probe& probe = result.probes.emplace_back();
      record >> verdict >> probe.line;
      probe.verdict = static_cast<Verdict>(verdict);
      why = &probe.why;
    } else {
      Acceptance& shader = result.shaders.emplace_back();
      record >> shader.line >> shader.model >> shader.is_expected >> shader.is_accepted;
      why = &shader.why;
    }
    record.get();
    std::getline(record, *why);
  }
  if (WIFSIGNALED(status)) {
    const int line = result.probes.empty() ? 0 : result.probes.back().line;
    result.probes.push_back(
        {Verdict::kRefused, line,
         "the process died of signal " + std::to_string(WTERMSIG(status)) + " after this line"});
  }
  return result;
}

}  // namespace clipc::values
