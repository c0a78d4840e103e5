// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/way.h"

namespace clipc::study {

// The GLSL of both stages.
struct WaySource {
  std::string vertex, fragment;
};
// Compiles a way's shaders with clipc. If `coverage`, the fragment shader adds 1; otherwise it
// shades. Throws DrawError with clipc's messages.
WaySource SourceOf(WayKind kind, int planes, bool coverage);

struct WayConstants {
  Mat4<float> world_view_projection, world;
  std::vector<Vec4<float>> planes;
};
// The constants for planes of world space, in double. None where the way cannot be used: xyw1 under
// an orthographic projection, the near plane with the eye on the kept side.
std::optional<WayConstants> ConstantsOf(WayKind kind, const Setup& setup,
                                        const std::vector<Plane>& world_planes);

}  // namespace clipc::study
