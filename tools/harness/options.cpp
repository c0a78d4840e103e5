// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/harness/options.h"

#include <cstdlib>
#include <fstream>

#include "tools/harness/offscreen.h"

namespace clipc::harness {
namespace options {

std::uint32_t ParseNumber(const std::string& text) {
  char* end = nullptr;
  const unsigned long value = std::strtoul(text.c_str(), &end, 0);
  if (text.empty() || *end != '\0' || value > 0xffffffff)
    throw DrawError("`" + text + "` is not a whole number");
  return value;
}

std::vector<std::string> Parse(const std::vector<std::string>& arguments, const Flags& flags) {
  std::vector<std::string> others;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (!argument.starts_with('-')) {
      others.push_back(argument);
      continue;
    }
    const std::size_t begin = argument.starts_with("--") ? 2 : 1, equals = argument.find('=');
    const auto found = flags.find(argument.substr(begin, equals - begin));
    if (found == flags.end()) throw DrawError("no option is called `" + argument + "`");
    const bool has_value = equals != argument.npos, takes_value = found->second.takes_value;
    if (has_value && !takes_value) throw DrawError("`" + argument + "` takes no value");
    if (takes_value && !has_value && i + 1 == arguments.size())
      throw DrawError("`" + argument + "` has no value");
    found->second.handle(has_value     ? argument.substr(equals + 1)
                         : takes_value ? arguments[++i]
                                       : "");
  }
  return others;
}

std::string ParseOnlyPath(const std::vector<std::string>& arguments, const Flags& flags) {
  const std::vector<std::string> paths = Parse(arguments, flags);
  if (paths.size() != 1) throw DrawError("one file is expected");
  return paths[0];
}

}  // namespace options

std::string ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw DrawError("cannot read `" + path + "`");
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace clipc::harness
