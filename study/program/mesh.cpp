// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/mesh.h"

#include <cmath>
#include <numbers>

namespace clipc::study {
namespace {

Vector Knot(double t) {
  const double r = 1 + 0.4 * std::cos(3 * t);
  return {r * std::cos(2 * t), r * std::sin(2 * t), 0.4 * std::sin(3 * t)};
}

struct Corner {
  Vec4<double> place;
  double normal[3];
};

// Clips by one plane, after Sutherland and Hodgman.
void ClipPolygon(std::vector<Corner>& polygon, const Vec4<double>& plane,
                 std::vector<Corner>& scratch) {
  scratch.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double from = Dot(a.place, plane), to = Dot(b.place, plane);
    if (from >= 0) scratch.push_back(a);
    if ((from >= 0) == (to >= 0)) continue;
    // Always from the end that is kept, so that triangles that share the edge share the cut.
    const bool forward = from >= 0;
    const Corner &kept = forward ? a : b, &dropped = forward ? b : a;
    const double k = forward ? from : to, d = forward ? to : from, t = k / (k - d);
    Corner cut;
    for (int c = 0; c < 4; ++c)
      cut.place[c] = kept.place[c] + t * (dropped.place[c] - kept.place[c]);
    for (int c = 0; c < 3; ++c)
      cut.normal[c] = kept.normal[c] + t * (dropped.normal[c] - kept.normal[c]);
    scratch.push_back(cut);
  }
  polygon.swap(scratch);
}

}  // namespace

Mesh TorusKnot(int along, int around, double scale) {
  constexpr double kTurn = 2 * std::numbers::pi;
  Mesh mesh;
  for (int i = 0; i < along; ++i) {
    const double t = kTurn * i / along;
    const Vector p = Knot(t), tangent = Unit(Knot(t + 1e-3) - p);
    const Vector side = Unit(Cross(tangent, {0.1, 0.2, 1})), up = Cross(side, tangent);
    for (int j = 0; j < around; ++j) {
      const double c = std::cos(kTurn * j / around), s = std::sin(kTurn * j / around);
      const Vector n = c * side + s * up, place = p + 0.3 * n;
      mesh.vertices.push_back(
          {{static_cast<float>(scale * place.x), static_cast<float>(scale * place.y),
            static_cast<float>(scale * place.z), 1}});
      for (const double x : {n.x, n.y, n.z}) mesh.normals.push_back(static_cast<float>(x));
    }
  }
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>(i % along * around + j % around);
  };
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      for (const std::uint32_t index :
           {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)}) {
        mesh.indices.push_back(index);
      }
    }
  }
  return mesh;
}

Mesh ClipMesh(const Mesh& mesh, const std::vector<Vec4<double>>& planes) {
  // Vertices that stay and triangles that are not cut keep their place.
  Mesh clipped = {mesh.vertices, mesh.normals, {}};
  std::vector<std::uint8_t> outside(mesh.vertices.size());
  for (std::size_t p = 0; p < planes.size(); ++p) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      if (!(Dot(ConvertTo<double>(mesh.vertices[i]), planes[p]) >= 0))
        outside[i] = static_cast<std::uint8_t>(outside[i] | 1u << p);
    }
  }
  std::vector<Corner> polygon, scratch;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint32_t* corner = &mesh.indices[i];
    const std::uint8_t a = outside[corner[0]], b = outside[corner[1]], c = outside[corner[2]];
    if ((a & b & c) != 0) continue;
    if ((a | b | c) == 0) {
      clipped.indices.insert(clipped.indices.end(), corner, corner + 3);
      continue;
    }
    polygon.clear();
    for (int k = 0; k < 3; ++k) {
      const float* n = &mesh.normals[3 * std::size_t{corner[k]}];
      polygon.push_back(
          {ConvertTo<double>(mesh.vertices[corner[k]]),
           {static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])}});
    }
    for (std::size_t p = 0; p < planes.size() && polygon.size() >= 3; ++p) {
      if (((a | b | c) >> p & 1) != 0) ClipPolygon(polygon, planes[p], scratch);
    }
    if (polygon.size() < 3) continue;
    const std::uint32_t first = clipped.vertices.size();
    for (const Corner& corner_of : polygon) {
      clipped.vertices.push_back(ConvertTo<float>(corner_of.place));
      for (const double x : corner_of.normal) clipped.normals.push_back(static_cast<float>(x));
    }
    for (std::uint32_t k = 2; k < polygon.size(); ++k) {
      for (const std::uint32_t index : {first, first + k - 1, first + k})
        clipped.indices.push_back(index);
    }
  }
  return clipped;
}

}  // namespace clipc::study
