// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/csv.h"

#include <cstdio>

#include <unistd.h>

#include "tools/harness/offscreen.h"

namespace clipc::study {

Csv::Csv(const std::string& path, std::initializer_list<const char*> columns)
    : path_(path), file_(path) {
  for (const char* column : columns) Add(column);
  EndRow();
}

void Csv::Add(const std::string& cell) {
  const bool quote = cell.find_first_of(",\"\n") != cell.npos;
  std::string text;
  for (const char c : cell) text += c == '"' ? "\"\"" : std::string(1, c);
  file_ << (first_ ? "" : ",") << (quote ? "\"" + text + "\"" : text);
  first_ = false;
}

void Csv::Add(double number) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6g", number);
  Add(text);
}

void Csv::EndRow() {
  file_ << '\n';
  file_.flush();
  first_ = true;
  if (!file_) throw harness::DrawError("cannot write `" + path_ + "`");
}

Progress::Progress(std::string what) : what_(std::move(what)), shown_(isatty(STDERR_FILENO) != 0) {
  (*this)(0);
}

Progress::~Progress() {
  if (shown_) std::fprintf(stderr, "\r%-60s\r", "");
}

void Progress::operator()(double share) {
  const int percent = static_cast<int>(100 * share);
  if (!shown_ || percent == last_) return;
  last_ = percent;
  std::fprintf(stderr, "\r%-40s %3d %%", what_.c_str(), percent);
  std::fflush(stderr);
}

}  // namespace clipc::study
