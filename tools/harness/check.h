// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <stdexcept>

#include "runtime/status.h"

namespace clipc::harness {

// Throws std::runtime_error with the runtime's own words where there is an error.
inline void Check(const runtime::Status& status) {
  if (!status.ok()) throw std::runtime_error(status.message());
}

template <typename T>
T Check(const runtime::Result<T>& result) {
  Check(result.status);
  return result.value;
}

}  // namespace clipc::harness
