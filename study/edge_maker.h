// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>

#include "study/method.h"
#include "study/setup.h"

namespace clipc::study {

// A triangle's edge that crosses a plane in the image.
struct Edge {
  Vec4<float> ends[2];  // object space
  Wide distances[2];    // the true distances, of different signs
};

// A place in the image.
struct Point {
  long double x, y;  // pixels
};
double Between(const Point& a, const Point& b);

// An edge as a camera sees it.
class SeenEdge {
 public:
  SeenEdge(const Setup& setup, const Edge& edge);
  // The edge between positions that float made: as it is drawn.
  SeenEdge(const Setup& setup, const Vec4<float>& first, const Vec4<float>& second);
  // The place that divides the edge in that share.
  Point At(long double share) const;

 private:
  Vec4<long double> clip_[2];  // positions, without float's rounding
  long double half_width_;     // pixels
};

// The place of a vertex, and of a clip-space position.
Point PointOf(const Setup& setup, const Vec4<float>& vertex);
Point PointOfPosition(const Setup& setup, const Vec4<float>& position);

// The share of the edge at which a clipper that gets these distances cuts it. Where it keeps the
// whole edge the cut has moved to the end that should have been dropped; where it drops the whole,
// to the one to be kept.
long double CutShare(const Edge& edge, const double (&distances)[2]);
// The share of the edge at which the plane truly cuts it.
long double TrueShare(const Edge& edge);

// Makes random edges. Vertices are rounded to float in object space first, so that no method pays
// for that. Equal seeds give equal edges.
class EdgeMaker {
 public:
  EdgeMaker(const Setup& setup, std::uint64_t seed);
  // An edge; none if the random numbers do not give one.
  std::optional<Edge> Next();

 private:
  Vector ChooseDirection();

  const Setup& setup_;
  const Config& config_;
  const Vector normal_;
  Random random_;
  Mat4<Wide> world_;
  Vec4<Wide> plane_;
};

// At most `count` random edges; fewer where it needs too many tries.
std::vector<Edge> MakeEdges(const Setup& setup, long count, std::uint64_t seed);

}  // namespace clipc::study
