// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "runtime/box_planner.h"
#include "tools/study/numbers.h"

namespace clipc::study {

// The part of a plane that a camera sees between two depths, as the corners of a convex polygon in
// view space; empty where it sees nothing. `view_plane` has a normal.
std::vector<Vector> VisibleCut(const Camera& camera, const Plane& view_plane, double nearest,
                               double farthest);

// What of that is inside the box of an object, which `to_view` takes to view space.
std::vector<Vector> CutOfBox(std::vector<Vector> visible, const runtime::Box& box,
                             const Matrix& to_view);

// A random place of such a polygon, which has a corner; all parts of the picture alike.
Vector RandomPlace(const std::vector<Vector>& polygon, const Camera& camera, Random& random);

}  // namespace clipc::study
