// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "tools/draw/compare.h"

namespace clipc::draw {

// GLSL's name of a scalar or vector type.
std::string TypeText(const ir::Type& type);
// The words before an input or output of that component kind that say how it is interpolated.
std::string QualifierOf(const ir::IoVar& io, ir::Scalar kind);

// A vertex shader that passes the random vertices on to a stage that reads several, and what it
// reads.
struct PassedOn {
  struct Attribute {
    std::string name;
    WordKind kind = WordKind::kFloat;
    Words words;  // of each vertex
  };

  std::string text;  // without its first line, the version
  std::vector<Attribute> attributes;
};

// The attributes have the locations 0, 1 and so on if the text is for Vulkan. Throws DrawError for
// inputs that no test draws with.
enum class PassOnFor { kOpenGl, kOpenGlEs, kVulkan };
PassedOn PassOn(const Shader& shader, const RandomInputs& random, PassOnFor api);

// The most vertices that the geometry shader makes of so many, which are whole primitives.
int MostEmitted(const ir::Emission& emission, int vertices);

}  // namespace clipc::draw
