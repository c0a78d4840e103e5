// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "runtime/plane_space.h"
#include "study/setup.h"
#include "study/way.h"

namespace clipc::study {

// The error of a way in a draw of one plane: pixels of an image of that height, the 99th
// percentiles of displaced edges. It is followed from the draw's own matrices and its cut through
// each rounding (runtime::PredictEdgeDisplacement); of `cpu`, whose cut becomes a vertex, it is
// that vertex's rounding. `order` is how float multiplies the matrices, `sine` that of the angle
// between surface and plane. 0 where the image shows nothing of the cut; infinity where the runtime
// refuses the way.
runtime::EdgeDisplacement LawOf(const Setup& setup, const Way& way, runtime::MatrixOrder order,
                                double image_height = kImageHeight,
                                double sine = runtime::kAnySurface);

}  // namespace clipc::study
