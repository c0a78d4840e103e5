// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>
#include <vector>

namespace clipc {

// The strings of a list from JavaScript, in which each ends with a zero.
inline std::vector<const char*> StringsIn(std::string_view list) {
  std::vector<const char*> strings;
  while (!list.empty()) {
    strings.push_back(list.data());
    list.remove_prefix(list.find('\0') + 1);
  }
  return strings;
}

}  // namespace clipc
