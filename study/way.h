// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

#include "clip-table/vocabulary.h"
#include "study/method.h"

namespace clipc::study {

// A way to clip as it is drawn and advised: by a shader that clipc compiled from
// program/method.hlsl, and its constants.
enum class WayKind {
  kNone,    // no clipping: costs are compared with it
  kObject,  // --plane-space=object
  kXyw1,    // --plane-space=xyw1
  kClip,    // [clipplanes], plane space clip: fxc, DXC, wined3d
  kLevel9,  // a level_9_1 shader and glClipPlane: SetClipPlane, Mesa's lowering of it
  kWorld,   // SV_ClipDistance from world space, by hand
  // --lower=near-plane --plane-space=object, scaled as runtime::ShearNearPlane says (Lengyel).
  kNearPlane,
  kNearPlaneFloat,     // the near plane by a product of float32 matrices
  kCpu,                // the application clips in double
  kDiscard,            // --lower=discard
  kDiscardObject,      // --lower=discard --plane-space=object
  kDiscardRecomputed,  // world position to the fragment shader, dot product there (three.js)
};

// The feature that the machine must have.
enum class Needs { kNothing, kDistances, kUserPlanes, kDiscard };

struct Way {
  WayKind kind;
  const char* name;
  int most_planes;  // the largest number of planes
  Needs needs;
  std::optional<PlaneSpace> space;  // the space of the planes; none: the world's
  // The lowering that clipc compiles it with; none for a shader without planes, and where distances
  // are by hand.
  std::optional<Lowering> lowering;
  Method (*method)();  // its arithmetic; null for kNone
};

// All ways, in the order of the enumerators. Of ways that are as good and as cheap the first one is
// advised: the way that does not flicker comes before those that do, and the ways that discard come
// last, as multisampling does not smooth their cuts.
inline constexpr Way kWays[] = {
    {WayKind::kNone, "none", 0, Needs::kNothing, {}, {}, nullptr},
    {WayKind::kObject, "object", 6, Needs::kDistances, PlaneSpace::kObject, Lowering::kClipDistance,
     ObjectSpace},
    {WayKind::kXyw1, "xyw1", 6, Needs::kDistances, PlaneSpace::kXyw1, Lowering::kClipDistance,
     Xyw1Space},
    {WayKind::kClip, "clip", 6, Needs::kDistances, PlaneSpace::kClip, Lowering::kClipDistance,
     ClipSpace},
    {WayKind::kLevel9, "level9", 6, Needs::kUserPlanes, PlaneSpace::kClip, Lowering::kLevel9,
     ClipSpace},
    {WayKind::kWorld, "world", 6, Needs::kDistances, {}, {}, WorldSpace},
    {WayKind::kNearPlane, "near-plane", 1, Needs::kNothing, PlaneSpace::kObject,
     Lowering::kNearPlane, NearPlane},
    {WayKind::kNearPlaneFloat, "near-plane-f32", 1, Needs::kNothing, {}, {}, NearPlaneFloat},
    {WayKind::kCpu, "cpu", 6, Needs::kNothing, PlaneSpace::kObject, {}, CpuDouble},
    {WayKind::kDiscard, "discard", 6, Needs::kDiscard, PlaneSpace::kClip, Lowering::kDiscard,
     ClipSpace},
    {WayKind::kDiscardObject, "discard-object", 6, Needs::kDiscard, PlaneSpace::kObject,
     Lowering::kDiscard, ObjectSpace},
    {WayKind::kDiscardRecomputed, "discard-world", 6, Needs::kDiscard, {}, {}, WorldSpace}};

constexpr const Way& WayOf(WayKind kind) { return kWays[static_cast<int>(kind)]; }
// The way of that name, which exists.
inline const Way& WayNamed(std::string_view name) {
  return *std::ranges::find(kWays, name, &Way::name);
}

// The arithmetic of a way whose shader multiplies by matrices in that order.
inline Method MethodOf(const Way& way, runtime::MatrixOrder order) {
  if (way.space == PlaneSpace::kClip) return ClipSpaceBy(order);
  if (way.space == PlaneSpace::kXyw1) return Xyw1SpaceBy(order);
  Method method = way.method();
  method.order = order;
  return method;
}

}  // namespace clipc::study
