// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tools/draw/arguments.h"

namespace clipc::draw {

// A long option.
struct Flag {
  bool takes_value;
  std::function<void(const std::string& value)> handle;
};

// Flags that set a variable: to their value, with their value at its end, to their value as a
// number, or, without a value, to true.
inline Flag Text(std::string& to) {
  return {true, [&to](const std::string& value) { to = value; }};
}
inline Flag Append(std::vector<std::string>& to) {
  return {true, [&to](const std::string& value) { to.push_back(value); }};
}
template <typename Integer>
Flag Number(Integer& to) {
  return {true, [&to](const std::string& value) { to = static_cast<Integer>(ParseNumber(value)); }};
}
inline Flag Switch(bool& to) {
  return {false, [&to](const std::string&) { to = true; }};
}
// A flag whose value `handle` takes.
inline Flag With(std::function<void(const std::string& value)> handle) {
  return {true, std::move(handle)};
}

// Calls the handlers of the options in the order of the arguments, and returns the arguments that
// are not options. Throws DrawError.
std::vector<std::string> ParseOptions(int argc, char** argv,
                                      const std::map<std::string, Flag>& flags);

// The only one of `paths`. Throws DrawError when there are none or several.
std::string OnlyPath(const std::vector<std::string>& paths);
// The bytes of a file. Throws DrawError when it cannot be read.
std::string ReadFile(const std::string& path);

}  // namespace clipc::draw
