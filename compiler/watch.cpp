// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/watch.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/path.h"
#include "base/spelling.h"
#include "base/system.h"
#include "compiler/batch/batch.h"
#include "compiler/command/show_messages.h"

namespace clipc {
namespace {

constexpr unsigned kPoll = 50;  // milliseconds

// What shows that a file is another one than before.
struct Stamp {
  std::int64_t modified = -1;  // -1: there is no such file
  std::uint64_t size = 0;
  std::pair<std::uint64_t, std::uint64_t> identity;

  friend bool operator==(const Stamp&, const Stamp&) = default;
};

using Stamps = std::map<std::string, Stamp>;

Stamp StampOf(const std::string& path) {
  const auto status = system::StatusOf(path);
  return status ? Stamp{status->modified, status->size, status->identity} : Stamp();
}

Stamps StampsOf(const Stamps& of) {
  Stamps stamps;
  for (const auto& [path, stamp] : of) stamps.emplace(path, StampOf(path));
  return stamps;
}

std::int64_t Now() {
  using std::chrono::duration_cast, std::chrono::nanoseconds, std::chrono::system_clock;
  return duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
}

std::string FolderOf(const std::string& path) {
  const std::size_t name = NameBegin(path);
  return name == 0 ? "." : path.substr(0, name);
}

class Watcher {
 public:
  Watcher(CommandLine&& command, const std::function<RunResult(CommandLine)>& run)
      : command_(std::move(command)),
        run_(run),
        is_whole_(command_.effect || WantsBatch(command_)),
        units_(is_whole_ ? 1 : command_.inputs.size()) {}

  int Watch();

 private:
  // Fails if the options are wrong. `due` are the numbers of the units to compile.
  bool Run(const std::vector<std::size_t>& due);
  std::vector<std::size_t> Changed() const;
  // The files that the command line names for a unit.
  std::vector<std::string> NamedFiles(std::size_t unit) const;
  Stamps Remember(std::size_t unit, const std::vector<std::string>& read, const Stamps& before,
                  std::int64_t start) const;

  CommandLine command_;
  const std::function<RunResult(CommandLine)>& run_;
  bool is_whole_;              // a batch or an effect, of one unit
  std::vector<Stamps> units_;  // what each input read
  int code_ = 0;
};

std::vector<std::string> Watcher::NamedFiles(std::size_t unit) const {
  std::vector<std::string> files = {command_.batch, command_.fragment, command_.pixel_shader.path};
  for (std::size_t i = 0; i < command_.inputs.size(); ++i) {
    if (is_whole_ || i == unit) files.push_back(command_.inputs[i]);
  }
  std::erase(files, "");
  return files;
}

// A file that was there before the run has its stamp of then, since it may have changed after it
// was read. So may a new one that is younger than the run; the clocks of files are some
// milliseconds late.
Stamps Watcher::Remember(std::size_t unit, const std::vector<std::string>& read,
                         const Stamps& before, std::int64_t start) const {
  constexpr std::int64_t kLate = 20'000'000;
  Stamps stamps;
  const auto add = [&](const std::string& path) {
    const auto known = before.find(path);
    Stamp stamp = known == before.end() ? StampOf(path) : known->second;
    if (known == before.end() && stamp.modified > start - kLate) stamp.modified = 0;
    stamps.emplace(path, stamp);
  };
  for (const std::string& path : NamedFiles(unit)) add(path);
  for (const std::string& path : read) add(path);
  if (code_ == 0) return stamps;
  std::set<std::string> folders(command_.request.includes.dirs.begin(),
                                command_.request.includes.dirs.end());
  for (const auto& [path, stamp] : stamps) folders.insert(FolderOf(path));
  for (const std::string& folder : folders) stamps.insert_or_assign(folder, StampOf(folder));
  return stamps;
}

bool Watcher::Run(const std::vector<std::size_t>& due) {
  const std::int64_t start = Now();
  Stamps before;
  CommandLine command = command_;
  if (!is_whole_) command.inputs.clear();
  for (const std::size_t unit : due) {
    for (const std::string& path : NamedFiles(unit)) before.emplace(path, StampOf(path));
    before.merge(StampsOf(units_[unit]));
    if (!is_whole_) command.inputs.push_back(command_.inputs[unit]);
  }
  const RunResult result = run_(std::move(command));
  code_ = result.code;
  if (result.files.empty() && units_[due.front()].empty()) return false;
  for (std::size_t i = 0; i < due.size(); ++i) {
    const Stamps& last = units_[due[i]];
    std::vector<std::string> read;
    for (const auto& [path, stamp] : last) read.push_back(path);
    units_[due[i]] = Remember(due[i], result.files.empty() ? read : result.files[i], before, start);
  }
  return true;
}

std::vector<std::size_t> Watcher::Changed() const {
  std::vector<std::size_t> changed;
  for (std::size_t unit = 0; unit < units_.size(); ++unit) {
    if (StampsOf(units_[unit]) != units_[unit]) changed.push_back(unit);
  }
  return changed;
}

int Watcher::Watch() {
  MessagePrinter printer(command_.format);
  std::vector<std::size_t> due;
  for (std::size_t unit = 0; unit < units_.size(); ++unit) due.push_back(unit);
  for (;;) {
    if (!Run(due) || system::IsInterrupted()) return code_;
    std::set<std::string> files;
    for (const Stamps& stamps : units_) {
      for (const auto& [path, stamp] : stamps) files.insert(path);
    }
    printer.Say(fmt::format("{}; watching {}", code_ == 0 ? "compiled" : "failed",
                            WithCount(files.size(), "file")));
    do {
      if (system::WaitForInterrupt(kPoll)) return code_;
      due = Changed();
    } while (due.empty());
    // An editor may write a file in several steps, and take it away in between.
    for (Stamps last;;) {
      Stamps now;
      for (const std::size_t unit : due) now.merge(StampsOf(units_[unit]));
      if (now == last) break;
      last = std::move(now);
      if (system::WaitForInterrupt(kPoll)) return code_;
    }
  }
}

}  // namespace

int WatchFiles(CommandLine command, const std::function<RunResult(CommandLine)>& run) {
  if (std::ranges::find(command.inputs, "-") != command.inputs.end())
    return Fail("--watch is for files, and `-` is standard input", command.format);
  system::CatchInterrupts();
  command.request.limits.is_cancelled = system::IsInterrupted;
  command.watch = false;
  return Watcher(std::move(command), run).Watch();
}

}  // namespace clipc
