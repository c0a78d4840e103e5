// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "tools/draw/compare.h"

namespace clipc::draw {

// A vertex shader that passes the random vertices on to a geometry shader, and what it reads.
struct PassedOn {
  struct Attribute {
    std::string name;
    WordKind kind = WordKind::kFloat;
    Words words;  // of each vertex
  };

  std::string text;  // without its first line, the version
  std::vector<Attribute> attributes;
  int vertices = 0;       // whole primitives
  int most_vertices = 0;  // that they can become
};

// The attributes have the locations 0, 1 and so on if the text is for Vulkan. Throws DrawError for
// inputs that no test draws with.
enum class PassOnFor { kOpenGl, kOpenGlEs, kVulkan };
PassedOn PassOn(const Trial& trial, PassOnFor api);

}  // namespace clipc::draw
