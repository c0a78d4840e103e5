// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace clipc::draw {

// A long option and what it does.
struct Flag {
  bool takes_value;
  std::function<void(const std::string& value)> handle;
};

// Calls the handlers of the options, in the order given, and returns what is no option. Throws
// DrawError.
std::vector<std::string> ParseOptions(int argc, char** argv,
                                      const std::map<std::string, Flag>& flags);

// The one shader among those. Throws DrawError when there are none or several.
std::string OnlyPath(const std::vector<std::string>& paths);
std::string ReadFile(const std::string& path);

}  // namespace clipc::draw
