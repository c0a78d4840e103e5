// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string_view>

#include "base/span.h"

namespace clipc::legalize {

// A loop that is too long to be unrolled, and the limit.
struct LongLoop {
  Span span;
  std::size_t limit;
  std::string_view of;
};

}  // namespace clipc::legalize
