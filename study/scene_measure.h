// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>

#include "study/scene.h"
#include "study/way.h"

namespace clipc::study {

// The displacement of the cuts of an object by the planes `needed`, a bit for each, with the
// scene's matrices and the float arithmetic of a way: the 99th percentile in pixels, of the plane
// where it is largest, against __float128. 0 where no cut is seen; none where the way does not
// apply. `edges`: of each plane, inside the object's box, evenly over the picture. Equal arguments
// give equal results.
std::optional<double> MeasureObject(const Scene& scene, const Camera& camera,
                                    const SceneObject& object, std::uint8_t needed, const Way& way,
                                    long edges, std::uint64_t seed);

// The setup of one plane through an object, with the part of its cut that is seen; none where no
// part is, or where the plane has no normal.
std::optional<Setup> SetupOf(const Camera& camera, const SceneObject& object, const Plane& plane);

}  // namespace clipc::study
