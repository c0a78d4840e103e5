// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <stdexcept>

#include "runtime/status.h"

namespace clipc::examples {

// Ends a program with the runtime's own words: throws std::runtime_error where there is an error.
inline void Check(const runtime::Status& status) {
  if (!status.ok()) throw std::runtime_error(status.message());
}

template <typename T>
T Check(const runtime::Result<T>& result) {
  Check(result.status);
  return result.value;
}

}  // namespace clipc::examples
