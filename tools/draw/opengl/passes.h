// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

namespace clipc::draw {

struct PassesDifference {
  int drawn = 0;    // pixels of the first pass
  int missing = 0;  // pixels of the first pass that the second does not draw
};

// Draws a mesh over the whole target with the first vertex shader in GLSL, and then with the
// second where its depth is equal, on the current context. Both get the same vertices by location.
// Throws DrawError where a shader reads anything else.
PassesDifference ComparePasses(const std::string& first, const std::string& second);

}  // namespace clipc::draw
