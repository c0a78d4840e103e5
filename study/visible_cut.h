// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "runtime/box_planner.h"
#include "study/numbers.h"

namespace clipc::study {

// The part of a plane that a camera sees between two depths, as the corners of a convex polygon in
// view space; empty where it sees nothing. `view_plane` has a normal.
std::vector<Vector> VisibleCut(const Camera& camera, const Plane& view_plane, double nearest,
                               double farthest);

// The part of a visible cut inside the box of an object, which `to_view` transforms to view space;
// empty where there is none.
std::vector<Vector> CutOfBox(std::vector<Vector> visible, const runtime::Box& box,
                             const Matrix& to_view);

// The part of a polygon on the kept side of a plane, and a little beyond it: what lies in the plane
// itself, but for rounding, is kept.
std::vector<Vector> KeptBy(const std::vector<Vector>& polygon, const Plane& view_plane);

// A random place of a polygon with at least one corner, evenly over the image; evenly over the
// polygon where the image shows a line.
Vector RandomPlace(const std::vector<Vector>& polygon, const Camera& camera, Random& random);

}  // namespace clipc::study
