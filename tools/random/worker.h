// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

#include "base/not_copied.h"
#include "tools/random/features.h"
#include "tools/random/judge.h"

namespace clipc::random {

// A process of its own that judges programs, so that a crash or a hang is one verdict more. It is
// started again when it has ended, and now and then so that drivers' leaks do not add up.
class Worker : NotCopied {
 public:
  Worker(JudgeOptions options, const Features& features);
  ~Worker();

  // Judges the program that the choices make.
  Verdict Run(const ChoiceList& choices, const std::optional<Verdict>& only = {});

 private:
  void Start();
  void Stop();
  Verdict Read();
  Verdict Ended(Fault fault, const std::string& step);
  std::string SaidOf() const;  // the text on the process's standard error

  JudgeOptions options_;
  Features features_;
  pid_t process_ = -1;
  int to_ = -1, from_ = -1;
  int runs_ = 0;
  std::string buffer_;
};

}  // namespace clipc::random
