// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace clipc::harness {

struct Vertex {
  float position[3];
  float normal[3];
};

// Three indices for each triangle. Some triangles show their back: draw both sides.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;

  // The corners of the axis-aligned box around the vertices.
  std::array<float, 3> low() const;
  std::array<float, 3> high() const;
};

// A teapot of 14 * detail^2 quads, about 3.4 wide along x, from y = -0.75 to 1: body, knob, spout
// (+x) and handle (-x).
Mesh Teapot(int detail);

// A torus around the y axis, through x = `radius`.
Mesh Torus(int detail, double radius, double tube_radius);

// The cube from (-1, -1, -1) to (1, 1, 1).
Mesh Cube();

// The square from (-size, 0, -size) to (size, 0, size) in parts * parts quads.
Mesh Ground(double size, int parts);

}  // namespace clipc::harness
