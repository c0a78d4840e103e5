// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "tools/study/numbers.h"

namespace clipc::study {

struct Mesh {
  std::vector<Vec4<float>> vertices;   // of object space, w = 1; or of clip space
  std::vector<float> normals;          // three for each vertex
  std::vector<std::uint32_t> indices;  // three for each triangle
};

// A tube around a (2, 3) torus knot within 1.75 of the origin: 2 * along * around triangles that
// overlap themselves.
Mesh TorusKnot(int along, int around, double scale, double flatten = 1);

// The part of `mesh` where dot(vertex, plane) >= 0 for each plane, computed in T: what the
// application clips itself. Cut vertices are rounded to float.
template <typename T>
Mesh ClipMesh(const Mesh& mesh, const std::vector<Vec4<T>>& planes);

}  // namespace clipc::study
