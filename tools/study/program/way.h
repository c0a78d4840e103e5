// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/study/setup.h"

namespace clipc::study {

// A way to clip as it is drawn: by a shader that clipc compiled from method.hlsl, and its
// constants.
enum class WayKind {
  kNone,    // no clipping: costs are compared with it
  kClip,    // [clipplanes], plane space clip: fxc, DXC, wined3d
  kXyw1,    // --plane-space=xyw1
  kObject,  // --plane-space=object
  kLevel9,  // a level_9_1 shader and glClipPlane: SetClipPlane, Mesa's lowering of it
  kWorld,   // SV_ClipDistance from world space, by hand
  // --lower=near-plane --plane-space=object, scaled as runtime::ShearNearPlane says (Lengyel).
  kNearPlane,
  kNearPlaneFloat,     // the near plane by a product of float32 matrices
  kDiscard,            // --lower=discard
  kDiscardObject,      // --lower=discard --plane-space=object
  kDiscardRecomputed,  // world position to the fragment shader, dot product there (three.js)
  kCpu,                // the application clips in double
};

struct Way {
  WayKind kind;
  const char* name;
  int most_planes;  // that it can clip by
};
const std::vector<Way>& AllWays();

// The GLSL of both stages.
struct WaySource {
  std::string vertex, fragment;
};
// Compiles with clipc. `coverage`: the fragment shader adds 1; otherwise it shades. Throws
// DrawError with clipc's messages.
WaySource SourceOf(WayKind kind, int planes, bool coverage);

struct WayConstants {
  Mat4<float> world_view_projection, world;
  std::vector<Vec4<float>> planes;
};
// The constants for planes of world space, in double. None where the way cannot be used: xyw1 under
// an orthographic projection, the near plane with the eye on the kept side.
std::optional<WayConstants> ConstantsOf(WayKind kind, const Setup& setup,
                                        const std::vector<runtime::Plane>& world_planes);

}  // namespace clipc::study
