// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "compiler/command/command_line.h"
#include "compiler/compile/message.h"
#include "compiler/compile/result.h"

// The messages of a run, on standard error or in a file.
namespace clipc {

// Prints `clipc: error: what`, or the document of a format that is one document. Returns the exit
// code for wrong usage.
int Fail(std::string_view what, MessageFormat format);

bool WantsColour(const CommandLine& command);

class MessagePrinter {
 public:
  // With a `file`, what would be printed is written there instead.
  explicit MessagePrinter(MessageFormat format, std::string file = {})
      : format_(format), file_(std::move(file)) {}

  void Show(const CompileResult& result);
  // Shows an error of the run itself. Returns the exit code for wrong usage.
  int Fail(std::string_view what);
  // Prints a line about the run itself, if the format has a place for it.
  void Say(std::string_view line);
  // Prints the number of errors and warnings to a terminal, or the document of a format that is one
  // document; then writes the file, unless it is one of those that were `read`. Returns the exit
  // code of the run, whose own is `code`. Call it last.
  int End(int code, const std::vector<std::string>& read);

 private:
  bool IsLines() const {
    return format_ == MessageFormat::kText || format_ == MessageFormat::kMsvc;
  }

  void Print(std::string_view text);
  std::string Document() const;
  Result<> WriteFile(const std::vector<std::string>& read) const;

  MessageFormat format_;
  std::string file_, text_;
  std::vector<Message> messages_;                    // of a format that is one document
  std::size_t error_count_ = 0, warning_count_ = 0;  // of what was shown as text
};

// "[12/200] water A=0": one line that is written over while a terminal watches.
class Progress {
 public:
  explicit Progress(bool is_wanted);
  ~Progress() { Clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void Say(std::size_t done, std::size_t count, std::string_view name);
  void Clear();  // before anything else is printed

 private:
  bool is_on_;
  bool is_shown_ = false;
  std::int64_t last_ = 0;  // in milliseconds
};

}  // namespace clipc
