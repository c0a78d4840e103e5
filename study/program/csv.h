// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <concepts>
#include <fstream>
#include <initializer_list>
#include <string>

namespace clipc::study {

// A table of comma-separated values, written as it grows. Throws DrawError when the file cannot be
// written.
class Csv {
 public:
  Csv(const std::string& path, std::initializer_list<const char*> columns);
  // Adds a row of strings and numbers; numbers that are not whole have six digits.
  template <typename... Cells>
  void Row(const Cells&... cells) {
    (Add(cells), ...);
    EndRow();
  }

 private:
  void Add(const std::string& cell);
  void Add(double number);
  template <std::integral Number>
  void Add(Number number) {
    Add(std::to_string(number));
  }
  void EndRow();

  std::string path_;
  std::ofstream file_;
  bool first_ = true;
};

// A line on standard error that says what the program does and how far it is; nothing is printed
// when standard error is not a terminal.
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();  // ends the line
  void operator()(double share);

 private:
  std::string what_;
  bool shown_;
  int last_ = -1;
};

}  // namespace clipc::study
