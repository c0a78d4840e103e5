// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <fstream>
#include <initializer_list>
#include <string>

namespace clipc::study {

// A table of comma-separated values, written as it grows. Throws DrawError when the file cannot be
// written.
class Csv {
 public:
  Csv(const std::string& path, std::initializer_list<const char*> columns);
  Csv& operator<<(const std::string& cell);
  Csv& operator<<(const char* cell) { return *this << std::string(cell); }
  Csv& operator<<(double number);  // six digits
  Csv& operator<<(long number) { return *this << std::to_string(number); }
  Csv& operator<<(int number) { return *this << std::to_string(number); }
  void EndRow();

 private:
  std::string path_;
  std::ofstream file_;
  bool first_ = true;
};

// One line on standard error that says what is being done and how far it is; nothing when that is
// no terminal.
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
