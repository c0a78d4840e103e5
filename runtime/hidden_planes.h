// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "box_planner.h"

namespace clipc::runtime {

/// `plan` without the planes whose cut other planes hide: all that such a plane removes of the box,
/// planes that stay remove too. kCulled if the planes together remove the whole box. PlanBox, which
/// looks at one plane at a time, keeps these: two mirrors in a corner, the far side of a portal.
/// `plan` is of the same box and planes.
///
/// What is clipped stays the same, by the bounds of PlanBox. But where such a plane cut a triangle,
/// and another cut it again, the triangle is cut once now, and what a clipper rounds may differ: a
/// pixel on the cut's edge, where PlanBox alone changes none.
///
/// A plane i is left out if there are weights k_j >= 0 of one to three planes j that stay with
/// (E_i - d_i(p)) + sum k_j (d_j(p) + E_j) < 0 at every p of the box (Farkas' lemma): where d_i may
/// be negative, so is some d_j, by more than its error. The box is removed if that holds with d_j +
/// E_j for E_i - d_i. Only plans of two planes and more take time. Pure: any thread, no allocation.
BoxPlan WithoutHiddenPlanes(const Box& box, const Float4* planes, std::size_t plane_count,
                            BoxPlan plan) noexcept;

}  // namespace clipc::runtime
