// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "study/numbers.h"

namespace clipc::study {

struct Mesh {
  std::vector<Vec4<float>> vertices;   // of object space, with w = 1; or of clip space
  std::vector<float> normals;          // three for each vertex
  std::vector<std::uint32_t> indices;  // three for each triangle
};

// A tube around a (2, 3) torus knot within 1.75 * scale of the origin, of 2 * along * around
// triangles. It hides parts of itself.
Mesh TorusKnot(int along, int around, double scale);

// The part of `mesh` where dot(vertex, plane) >= 0 for each plane, as an application clips it in
// double. Cut vertices are rounded to float.
Mesh ClipMesh(const Mesh& mesh, const std::vector<Vec4<double>>& planes);

}  // namespace clipc::study
