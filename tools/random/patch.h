// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "tools/random/interface.h"

// The entries of shaders of patches, with their structs.
namespace clipc::random {

// A hull shader of up to sixteen control points, and the function of its constants, which reads the
// points before and after the hull shader ran.
std::string MakePatchEntry(Context& context);

// A domain shader, `planes` before it, and the hull shader that says how the domain is cut.
std::string MakeDomainEntry(Context& context, const std::string& planes);

}  // namespace clipc::random
