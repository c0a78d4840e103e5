// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tools/draw/compare.h"

namespace clipc::draw {

WordKind KindOf(ir::Scalar scalar);
// GLSL's name of a scalar or vector type.
std::string TypeText(const ir::Type& type);
// The words before an input or output of that component kind that say how it is interpolated.
std::string QualifierOf(const ir::IoVar& io, ir::Scalar kind);

// The shaders before one that reads several vertices, which pass the random ones on.
struct PassedOn {
  struct Attribute {
    std::string name;
    WordKind kind = WordKind::kFloat;
    Words words;  // of each vertex
  };

  // Without their first lines, the version. A hull shader is there for a domain shader.
  std::string vertex, hull;
  std::vector<Attribute> attributes;
  int vertices = 0;  // of whole primitives or patches
};

// The attributes have the locations 0, 1 and so on if the text is for Vulkan. Throws DrawError for
// inputs that no test draws with.
enum class PassOnFor { kOpenGl, kOpenGlEs, kVulkan };
PassedOn PassOn(const Shader& shader, const RandomInputs& random, PassOnFor api);

// "layout(location = 3) ".
std::string LocationText(std::size_t location);
// "highp " where variables of a stage need it.
std::string_view PrecisionText(PassOnFor api);

// The vertices of a primitive or patch that the shader runs for, at least one.
int VerticesOfOne(const ir::Program& program);
// The most vertices that the geometry shader makes of so many, which are whole primitives.
int MostEmitted(const ir::Emission& emission, int vertices);

}  // namespace clipc::draw
