// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/interface.h"

#include <algorithm>
#include <functional>
#include <ranges>

#include "ir/scalar.h"

namespace clipc::ir {

std::uint32_t LocationCount(const Type& type) {
  return IsWide(type.scalar) && type.Components() > 2 ? 2 : 1;
}

void SortByLocation(IoVars& list) {
  const auto is_built_in = [](const IoVar& io) { return io.builtin != Builtin::kNone; };
  if (std::ranges::is_sorted(list | std::views::filter(std::not_fn(is_built_in)), {},
                             &IoVar::location))
    return;
  const auto rest = std::ranges::stable_partition(list, is_built_in);
  std::ranges::stable_sort(rest, {}, &IoVar::location);
}

}  // namespace clipc::ir
