// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/visible_cut.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace clipc::study {
namespace {

// The width of a polygon, by its length, that the image shows as a line.
constexpr double kThin = 1e-3;
// The distance beyond a plane that counts as kept, by the largest number that the distance is made
// of.
constexpr double kBeyond = 1e-7;

double At(const Plane& plane, Vector p) {
  return plane.x * p.x + plane.y * p.y + plane.z * p.z + plane.w;
}

// The part of the polygon on the plane's kept side.
std::vector<Vector> Kept(const std::vector<Vector>& polygon, const Plane& plane) {
  std::vector<Vector> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double at_a = At(plane, a), at_b = At(plane, b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

}  // namespace

std::vector<Vector> VisibleCut(const Camera& camera, const Plane& view_plane, double nearest,
                               double farthest) {
  const Vector normal = NormalOf(view_plane);
  const double squared = Dot(normal, normal);
  // A square of the plane that is larger than all that the camera sees.
  const double high = camera.HalfHeightAt(farthest), across = 1 + camera.aspect;
  const double shift = 1 + std::fabs(camera.offset_x) + std::fabs(camera.offset_y);
  const double size = 4 * (farthest + high * across * shift);
  const Vector middle = {0, 0, (nearest + farthest) / 2};
  const Vector centre = middle - At(view_plane, middle) / squared * normal;
  const Vector other =
      std::fabs(normal.x) * std::fabs(normal.x) < squared / 2 ? Vector{1, 0, 0} : Vector{0, 1, 0};
  const Vector u = size * Unit(Cross(normal, other)), v = size * Unit(Cross(normal, u));
  std::vector<Vector> polygon = {centre + u, centre + v, centre - u, centre - v};
  // Depth first: sides alone do not bound what is seen.
  polygon = Kept(polygon, {0, 0, 1, -nearest});
  polygon = Kept(polygon, {0, 0, -1, farthest});
  const Matrix projection = camera.Projection();
  const Plane sides[] = {{1, 0, 0, 1}, {-1, 0, 0, 1}, {0, 1, 0, 1}, {0, -1, 0, 1}};
  for (const Plane& side : sides) polygon = Kept(polygon, PlaneBefore(projection, side));
  return polygon;
}

std::vector<Vector> CutOfBox(std::vector<Vector> visible, const runtime::Box& box,
                             const Matrix& to_view) {
  // A plane goes from the object's space to view space by the inverse of the matrix.
  const Mat4<double> inverse = InverseOf(ConvertTo<double>(to_view));
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool is_high : {false, true}) {
      const double at = static_cast<double>(is_high ? box.high[axis] : box.low[axis]);
      Vec4<double> side = {{0, 0, 0, is_high ? at : -at}};
      side[axis] = is_high ? -1 : 1;
      const Vec4<double> seen = PlaneThrough(inverse, side);
      visible = Kept(visible, {seen[0], seen[1], seen[2], seen[3]});
    }
  }
  return visible;
}

std::vector<Vector> KeptBy(const std::vector<Vector>& polygon, const Plane& view_plane) {
  const Vector normal = NormalOf(view_plane);
  double largest = std::fabs(view_plane.w);
  for (const Vector& p : polygon)
    largest = std::max(largest, std::sqrt(Dot(normal, normal) * Dot(p, p)));
  Plane beyond = view_plane;
  beyond.w += kBeyond * largest;
  return Kept(polygon, beyond);
}

Vector RandomPlace(const std::vector<Vector>& polygon, const Camera& camera, Random& random) {
  const Vector first = polygon[0];
  if (polygon.size() < 3) return first;
  // Triangles around the first corner, by twice their size: in the image, or in space where the
  // image shows a line, as of a plane that holds the eye.
  const auto in_image = [&](Vector p) {
    const double w = camera.orthographic ? 1 : p.z;
    return Vector{p.x / w, p.y / w, 0};
  };
  std::vector<double> seen, sizes;
  double longest = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vector a = in_image(polygon[i]) - in_image(first),
                 b = in_image(polygon[i + 1]) - in_image(first);
    const Vector across = Cross(polygon[i] - first, polygon[i + 1] - first);
    seen.push_back(std::fabs(a.x * b.y - a.y * b.x));
    sizes.push_back(std::sqrt(Dot(across, across)));
    longest = std::max({longest, Dot(a, a), Dot(b, b)});
  }
  const bool is_line = !(std::accumulate(seen.begin(), seen.end(), 0.0) > kThin * longest);
  if (!is_line) sizes = std::move(seen);
  double left = random.Between(0, std::accumulate(sizes.begin(), sizes.end(), 0.0));
  std::size_t chosen = 0;
  for (; chosen + 1 < sizes.size() && left > sizes[chosen]; ++chosen) left -= sizes[chosen];
  // Even shares of the triangle in the image, turned into shares of the triangle in space.
  double u = random.Unit(), v = random.Unit();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const auto share = [&](double even, Vector corner) {
    return is_line || camera.orthographic ? even : even / corner.z;
  };
  const Vector second = polygon[chosen + 1], third = polygon[chosen + 2];
  const double shares[3] = {share(1 - u - v, first), share(u, second), share(v, third)};
  const double all = shares[0] + shares[1] + shares[2];
  return shares[0] / all * first + shares[1] / all * second + shares[2] / all * third;
}

}  // namespace clipc::study
