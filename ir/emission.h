// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "ir/ids.h"

// What a stage that emits vertices takes and gives: a geometry shader.
namespace clipc::ir {

enum class Primitive : std::uint8_t {
  kPoint,
  kLine,
  kTriangle,
  kLineAdjacent,      // a line with the vertex before it and the one after it
  kTriangleAdjacent,  // a triangle, and after each of its vertices one of the next triangle
};
struct PrimitiveInfo {
  std::string_view name;       // HLSL's word for it as an input: "lineadj"
  std::uint32_t vertices = 0;  // that it has
};
inline constexpr PrimitiveInfo kPrimitives[] = {
    {"point", 1}, {"line", 2}, {"triangle", 3}, {"lineadj", 4}, {"triangleadj", 6}};
constexpr const PrimitiveInfo& InfoOf(Primitive primitive) {
  return kPrimitives[static_cast<std::size_t>(primitive)];
}

// A stream of vertices. `emit` writes the outputs of a vertex, its parameter, and emits it: all
// outputs of the stream are written there and nowhere else.
struct Stream {
  VarId object;  // the parameter of the entry function
  FunctionId emit;
};

struct Emission {
  Primitive input = Primitive::kPoint;
  bool takes_primitive = false;          // whether it reads the vertices of one
  Primitive output = Primitive::kPoint;  // a point, a strip of lines or a strip of triangles
  std::uint32_t max_vertices = 0;        // [maxvertexcount]
  std::uint32_t instances = 1;           // [instance]: how often it runs for a primitive
  std::vector<Stream> streams;           // by number; empty in a stage that emits no vertices
};

}  // namespace clipc::ir
