// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/state_values.h"

#include "base/spelling.h"

namespace clipc {

bool IsSameState(std::string_view a, std::string_view b) {
  for (std::size_t i = 0, k = 0;; ++i, ++k) {
    while (i < a.size() && a[i] == '_') ++i;
    while (k < b.size() && b[k] == '_') ++k;
    if (i >= a.size() || k >= b.size()) return i >= a.size() && k >= b.size();
    if (ToLower(a[i]) != ToLower(b[k])) return false;
  }
}

}  // namespace clipc
