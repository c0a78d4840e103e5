// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/command/option_table.h"

#include <algorithm>
#include <cstdint>

namespace clipc {
namespace {

// Calls visit(spelling) for each name of each option that has one with such a start.
void ForEachSpelling(std::uint64_t starts, auto visit) {
  for (const std::span<const Option> table : {OwnOptions(), ForeignOptions()}) {
    for (const Option& option : table) {
      if ((option.starts & starts) == 0) continue;
      std::string_view names = option.names;
      while (!names.empty()) {
        const std::string_view name = names.substr(0, names.find(' '));
        visit(Spelling{name, &option});
        names.remove_prefix(std::min(name.size() + 1, names.size()));
      }
    }
  }
}

}  // namespace

std::vector<std::string_view> Spellings() {
  std::vector<std::string_view> names;
  ForEachSpelling(~std::uint64_t{0},
                  [&](const Spelling& spelling) { names.push_back(spelling.name); });
  return names;
}

Spelling FindOption(std::string_view argument) {
  Spelling found;
  ForEachSpelling(StartOf(argument), [&](const Spelling& spelling) {
    if (!argument.starts_with(spelling.name)) return;
    const std::string_view rest = argument.substr(spelling.name.size());
    const Option::Form form = spelling.option->form;
    const bool fits = rest.empty() || form == Option::Form::kJoined ||
                      form == Option::Form::kJoinedOrSeparate ||
                      form == Option::Form::kDefinition || form == Option::Form::kOptional ||
                      ((form == Option::Form::kEquals || form == Option::Form::kNumbers) &&
                       rest.starts_with('='));
    if (fits && spelling.name.size() > found.name.size()) found = spelling;
  });
  return found;
}

}  // namespace clipc
