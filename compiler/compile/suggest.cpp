// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/suggest.h"

#include <vector>

#include <fmt/format.h>

#include "base/spelling.h"

namespace clipc {
namespace {

// The names as a choice: "`a`, `b` or `c`".
std::string Choices(std::span<const std::string_view> names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const char* separator = i == 0 ? "" : i + 1 == names.size() ? " or " : ", ";
    text += fmt::format("{}`{}`", separator, names[i]);
  }
  return text;
}

}  // namespace

std::string Suggest(std::string_view name, std::span<const std::string_view> names) {
  constexpr std::size_t kFew = 32;
  if (const auto near = NearNames(name, names); !near.empty())
    return fmt::format("; did you mean {}?", Choices(near));
  std::vector<std::string_view> longer;
  for (const std::string_view one : names) {
    if (name.size() > 2 && one.starts_with(name)) longer.push_back(one);
  }
  if (longer.size() == 1 || longer.size() == 2)
    return fmt::format("; did you mean {}?", Choices(longer));
  return names.empty() || names.size() > kFew ? std::string()
                                              : fmt::format("; there is {}", Choices(names));
}

}  // namespace clipc
