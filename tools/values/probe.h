// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "tools/values/resource.h"
#include "tools/values/script.h"

namespace clipc::values {

// Compares the values of a resource with those of a probe: "(0, 0) rgba (0.25, 0, 0.25, 0) 2".
// Returns what differs, or an empty text.
std::string DifferenceOf(const Resource& resource, Scanner& line);

}  // namespace clipc::values
