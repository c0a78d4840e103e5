// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/harness/mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/harness/transform.h"

namespace clipc::harness {
namespace {

using std::numbers::pi;

// Adds the surface point(u, v), with u and v from 0 to 1 in so many steps. Normals come from its
// slopes.
template <typename Point>
void AddSurface(Mesh& mesh, int u_steps, int v_steps, Point point) {
  constexpr double kStep = 1e-4;
  const std::uint32_t first = mesh.vertices.size();
  for (int i = 0; i <= u_steps; ++i) {
    for (int j = 0; j <= v_steps; ++j) {
      const double u = static_cast<double>(i) / u_steps, v = static_cast<double>(j) / v_steps;
      const Vector p = point(u, v);
      const Vector n = Unit(Cross(point(u, v + kStep) - point(u, v - kStep),
                                  point(u + kStep, v) - point(u - kStep, v)));
      mesh.vertices.push_back(
          {{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
           {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)}});
    }
  }
  const std::uint32_t row = v_steps + 1;
  for (int i = 0; i < u_steps; ++i) {
    for (int j = 0; j < v_steps; ++j) {
      const std::uint32_t a = first + i * row + j, b = a + row;
      for (const std::uint32_t corner : {a, b, a + 1, a + 1, b, b + 1})
        mesh.indices.push_back(corner);
    }
  }
}

// A tube of radius(u) in the plane z = 0 along the curve center(u).
template <typename Center, typename Radius>
void AddTube(Mesh& mesh, int detail, Center center, Radius radius) {
  AddSurface(mesh, 2 * detail, detail, [&](double u, double v) {
    const Vector c = center(u), along = Unit(center(u + 1e-3) - center(u - 1e-3));
    const double a = 2 * pi * v, r = radius(u);
    return Vector{c.x - r * std::cos(a) * along.y, c.y + r * std::cos(a) * along.x,
                  r * std::sin(a)};
  });
}

template <typename Choose>
std::array<float, 3> Corner(const Mesh& mesh, Choose choose) {
  std::array<float, 3> corner{};
  for (int axis = 0; axis < 3; ++axis) {
    corner[axis] = mesh.vertices.empty() ? 0 : mesh.vertices[0].position[axis];
    for (const Vertex& vertex : mesh.vertices)
      corner[axis] = choose(corner[axis], vertex.position[axis]);
  }
  return corner;
}

}  // namespace

std::array<float, 3> Mesh::low() const {
  return Corner(*this, [](float a, float b) { return std::min(a, b); });
}
std::array<float, 3> Mesh::high() const {
  return Corner(*this, [](float a, float b) { return std::max(a, b); });
}

Mesh Teapot(int detail) {
  Mesh mesh;
  // The poles of body and knob keep a hole of 0.0005, so that they have normals.
  const auto turned = [](double radius, double height, double v) {
    const double a = -2 * pi * v;
    return Vector{radius * std::cos(a), height, radius * std::sin(a)};
  };
  AddSurface(mesh, detail, 4 * detail, [&](double u, double v) {
    const double a = pi * (0.0005 + 0.999 * u);
    return turned(std::sin(a) * (1 - 0.15 * std::cos(a)), -0.75 * std::cos(a), v);
  });
  AddSurface(mesh, detail, 4 * detail, [&](double u, double v) {
    const double a = pi * (0.0005 + 0.999 * u);
    return turned(0.13 * std::sin(a), 0.87 - 0.13 * std::cos(a), v);
  });
  AddTube(
      mesh, detail, [](double u) { return Vector{0.85 + 0.75 * u, -0.25 + 0.75 * u * u, 0}; },
      [](double u) { return 0.24 - 0.14 * u; });
  AddTube(
      mesh, detail,
      [](double u) {
        const double a = pi * (0.5 + u);
        return Vector{-0.78 + 0.67 * std::cos(a), 0.05 + 0.42 * std::sin(a), 0};
      },
      [](double) { return 0.09; });
  return mesh;
}

Mesh Torus(int detail, double radius, double tube_radius) {
  Mesh mesh;
  AddSurface(mesh, 2 * detail, detail, [&](double u, double v) {
    const double a = 2 * pi * u, b = 2 * pi * v, r = radius + tube_radius * std::cos(b);
    return Vector{r * std::cos(a), tube_radius * std::sin(b), r * std::sin(a)};
  });
  return mesh;
}

Mesh Cube() {
  Mesh mesh;
  for (int side = 0; side < 6; ++side) {
    AddSurface(mesh, 1, 1, [&](double u, double v) {
      const double p[3] = {side % 2 == 0 ? -1.0 : 1.0, 2 * u - 1,
                           side % 2 == 0 ? 2 * v - 1 : 1 - 2 * v};
      return Vector{p[side / 2], p[(side / 2 + 1) % 3], p[(side / 2 + 2) % 3]};
    });
  }
  return mesh;
}

Mesh Ground(double size, int parts) {
  Mesh mesh;
  AddSurface(mesh, parts, parts,
             [&](double u, double v) { return Vector{size * (2 * u - 1), 0, size * (2 * v - 1)}; });
  return mesh;
}

}  // namespace clipc::harness
