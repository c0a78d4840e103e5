// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

// The command lines of the tools.
namespace clipc::harness::options {

// An option: "--name value", "--name=value" or, without a value, "--name"; one dash does too.
struct Flag {
  bool takes_value;
  std::function<void(const std::string& value)> handle;
};
using Flags = std::map<std::string, Flag>;  // by name, without dashes

// Parses a whole number, "0x3" or "3". Throws DrawError for anything else.
std::uint32_t ParseNumber(const std::string& text);

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
inline Flag On(bool& to) {
  return {false, [&to](const std::string&) { to = true; }};
}
// A flag whose value `handle` reads.
inline Flag With(std::function<void(const std::string& value)> handle) {
  return {true, std::move(handle)};
}

// Calls the handlers of the options in the order of the arguments, and returns the arguments that
// are not options. arguments[0] is the command's name, which is left out. Throws DrawError.
std::vector<std::string> Parse(const std::vector<std::string>& arguments, const Flags& flags);
// Parses arguments of which exactly one is not an option, and returns that one.
std::string ParseOnlyPath(const std::vector<std::string>& arguments, const Flags& flags);

}  // namespace clipc::harness::options

namespace clipc::harness {

// The bytes of a file. Throws DrawError when it cannot be read.
std::string ReadFile(const std::string& path);

}  // namespace clipc::harness
