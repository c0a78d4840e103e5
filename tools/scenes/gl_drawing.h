// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "clip-table/vocabulary.h"
#include "runtime/table.h"
#include "tools/harness/image.h"
#include "tools/scenes/scene.h"

// Draws the scene on OpenGL, with the shaders that clipc wrote. An OpenGL 4.5 context of the
// compatibility profile must be current. All functions throw std::runtime_error where they fail.
namespace clipc::scenes {

// Draws the scene with a lowering, but not with kNone, and with kNearPlane only if it has one
// plane. The mistake is made by PlaneConstants and MistakenTable.
harness::Image DrawScene(Lowering lowering, const Scene& scene, Mistake mistake = Mistake::kNone);

// The scene with three planes under level 9, its objects drawn by skinned.hlsl.
harness::Image DrawSkinned(const Scene& scene);

// The image when a point is kept that is on the kept side of all planes, or of any of them. It is
// decided pixel by pixel in world space, without anything of clipc's.
enum class Kept { kByAll, kByAny };
harness::Image DrawKept(const Scene& scene, Kept kept);

// An image of where images may differ: white within one pixel of the cut of a plane through a
// surface that the other planes keep, seen or hidden; black elsewhere. It is computed from
// distances in world space, not from clip space.
harness::Image DrawCuts(const Scene& scene);

// The distance in pixels by which float arithmetic moves a cut of this scene when planes are in
// clip space, at most for 99 % of the cuts: the largest PredictEdgeError of plane space `clip`.
double CutError(const Scene& scene);

}  // namespace clipc::scenes
