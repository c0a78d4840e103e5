// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "tools/draw/surface.h"

namespace clipc::draw {

// Draws the surface with these shaders and returns the values of each target, in their order. A
// context that VersionOf(fragment) names must be current. A pixel has `samples`, which are resolved
// into one value at the end.
std::vector<Captured> DrawSurface(const std::string& vertex, const std::string& fragment,
                                  const std::vector<SurfaceTarget>& targets, const Inputs& inputs,
                                  const SurfaceSpace& space, int samples);

}  // namespace clipc::draw
