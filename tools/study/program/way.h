// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/study/setup.h"

namespace clipc::study {

// A way to clip as it is drawn: a shader that clipc compiled from method.hlsl, and the constants
// that it wants.
enum class WayKind {
  kNone,       // no clipping: what costs are compared with
  kClip,       // [clipplanes], plane space clip: fxc, DXC, wined3d
  kXyw1,       // --plane-space=xyw1
  kObject,     // --plane-space=object
  kLevel9,     // a level_9_1 shader and glClipPlane: SetClipPlane, Mesa's lowering of it
  kWorld,      // SV_ClipDistance from world space, by hand
  kNearPlane,  // --lower=near-plane --plane-space=object, scaled as runtime::ShearNearPlane says
               // (Lengyel)
  kNearPlaneFloat,     // the near plane by float matrix products (the paper)
  kDiscard,            // --lower=discard
  kDiscardObject,      // --lower=discard --plane-space=object
  kDiscardRecomputed,  // world position to the fragment shader, dot product there (three.js)
  kCpu,                // the application clips in double
};

struct Way {
  WayKind kind;
  const char* name;
  const char*
      arithmetic;  // the tools/study/method.h method that computes as this way does; empty for none
  int most_planes;
};
const std::vector<Way>& AllWays();

// GLSL of both stages. `coverage`: the fragment shader adds 1; else it shades.
struct WaySource {
  std::string vertex, fragment;
};
// Compiles with clipc. Throws DrawError with its messages.
WaySource SourceOf(WayKind kind, int planes, bool coverage);

struct WayConstants {
  Mat4<float> world_view_projection, world;
  std::vector<Vec4<float>> planes;
};
// `world_planes` are doubles of world space. Nothing where the way cannot be used: xyw1 under an
// orthographic projection, the near plane with the eye on the kept side.
std::optional<WayConstants> ConstantsOf(WayKind kind, const Setup& setup,
                                        const std::vector<runtime::Plane>& world_planes);

}  // namespace clipc::study
