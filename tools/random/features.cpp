// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/features.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "tools/harness/offscreen.h"

namespace clipc::random {
namespace {

struct Row {
  const char* name;
  bool on;
  const char* what;
};
constexpr Row kRows[] = {
#define FEATURE(Enumerator, Name, On, What) {Name, On, What},
#include "tools/random/features.def"
};

}  // namespace

Features::Features() {
  for (std::size_t i = 0; i < std::size(kRows); ++i) set_[i] = kRows[i].on;
}

void Features::Set(const std::string& names, bool on) {
  std::istringstream parts(names);
  for (std::string name; std::getline(parts, name, ',');) {
    const auto* const row =
        std::ranges::find_if(kRows, [&](const Row& known) { return known.name == name; });
    if (row == std::end(kRows)) throw harness::DrawError("no feature is called `" + name + "`");
    set_[static_cast<std::size_t>(row - kRows)] = on;
  }
}

std::string Features::List() {
  std::string text;
  for (const Row& row : kRows) {
    const std::string name = row.name;
    text += "    " + name + std::string(24 - name.size(), ' ') + (row.on ? "on   " : "off  ") +
            row.what + "\n";
  }
  return text;
}

}  // namespace clipc::random
