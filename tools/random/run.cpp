// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/run.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>

#include <unistd.h>

#include "base/not_copied.h"
#include "tools/harness/offscreen.h"
#include "tools/random/reduce.h"
#include "tools/random/report.h"
#include "tools/random/worker.h"

namespace clipc::random {
namespace {

using Clock = std::chrono::steady_clock;

// A temporary folder that exists for the time of the run.
class Scratch : NotCopied {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "clipc-random-XXXXXX").string();
    if (!mkdtemp(name.data())) throw harness::DrawError("no temporary folder");
    path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

class Runner {
 public:
  explicit Runner(const RunOptions& options)
      : options_(options), worker_({scratch_.path(), options.draws, {}}, options.features) {}

  int Run() {
    if (!options_.repeat.empty()) {
      One(ReadChoices(options_.repeat), "repeated");
    } else {
      for (std::uint64_t i = 0; !IsOver(i); ++i) {
        Choices choices(options_.seed + i);
        MakeProgram(choices, options_.features);
        One(choices.drawn(), std::to_string(options_.seed + i));
        if (isatty(STDERR_FILENO) != 0) {
          std::fprintf(stderr, "\rprograms: %llu, failures: %llu ",
                       static_cast<unsigned long long>(programs_),
                       static_cast<unsigned long long>(failures_));
        }
      }
      if (isatty(STDERR_FILENO) != 0) std::fputs("\n", stderr);
    }
    Summarise();
    return failures_ == 0 ? 0 : 1;
  }

 private:
  bool IsOver(std::uint64_t index) const {
    if (options_.stops && failures_ > 0) return true;
    if (options_.count > 0 && index >= options_.count) return true;
    const double passed = std::chrono::duration<double>(Clock::now() - begin_).count();
    return options_.seconds > 0 && passed >= options_.seconds;
  }

  void One(const ChoiceList& choices, const std::string& name) {
    ++programs_;
    if (options_.prints) std::fputs(ProgramOf(choices).text.c_str(), stdout);
    const Verdict verdict = worker_.Run(choices);
    if (verdict.fault == Fault::kNone) return;
    ++failures_;
    if (++known_[verdict.Key()] > 1) return;
    const ChoiceList reduced =
        options_.reduces && options_.repeat.empty() ? Reduced(choices, verdict) : choices;
    const Verdict last = worker_.Run(reduced, verdict);
    const std::string folder =
        WriteFailure(options_.out, name, ProgramOf(choices), ProgramOf(reduced),
                     last.fault == Fault::kNone ? verdict : last, reduced, options_.feature_flags);
    std::printf("%s, seed %s: %s\n", std::string(NameOf(verdict.fault)).c_str(), name.c_str(),
                folder.c_str());
    std::printf("    %s\n", verdict.what.substr(0, verdict.what.find('\n')).c_str());
    std::fflush(stdout);
  }

  Program ProgramOf(const ChoiceList& list) const {
    Choices choices(list);
    return MakeProgram(choices, options_.features);
  }

  ChoiceList Reduced(const ChoiceList& list, const Verdict& verdict) {
    Reduction reduction;
    reduction.make = [&](const ChoiceList& some) {
      Choices choices(some);
      MakeProgram(choices, options_.features);
      return Made{choices.drawn(), choices.spans()};
    };
    reduction.fails = [&](const ChoiceList& some) {
      const Verdict found = worker_.Run(some, verdict);
      return found.fault == verdict.fault && found.Key() == verdict.Key();
    };
    if (verdict.fault == Fault::kHang) reduction.most_tries = 20;
    return Reduce(list, reduction);
  }

  void Summarise() const {
    const double passed = std::chrono::duration<double>(Clock::now() - begin_).count();
    std::printf("programs: %llu, from seed %llu in %.0f s; failures: %llu\n",
                static_cast<unsigned long long>(programs_),
                static_cast<unsigned long long>(options_.seed), passed,
                static_cast<unsigned long long>(failures_));
    for (const auto& [key, count] : known_) std::printf("%6d  %s\n", count, key.c_str());
  }

  const RunOptions& options_;
  Scratch scratch_;
  Worker worker_;
  Clock::time_point begin_ = Clock::now();
  std::uint64_t programs_ = 0, failures_ = 0;
  std::map<std::string, int> known_;  // by Verdict::Key
};

}  // namespace

int RunPrograms(const RunOptions& options) { return Runner(options).Run(); }

}  // namespace clipc::random
