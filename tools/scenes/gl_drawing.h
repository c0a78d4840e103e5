// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "examples/shared/offscreen.h"
#include "runtime/table.h"
#include "tools/scenes/scene.h"

// The scene on OpenGL, through the shaders that clipc wrote. An OpenGL 4.5 context of the
// compatibility profile must be current. What fails throws std::runtime_error.
namespace clipc::scenes {

enum class Way { kClipDistance, kLevel9, kDiscard, kNearPlane };
const char* NameOf(Way way);

// kNearPlane only with one plane. Mistakes as PlaneConstants and MistakenTable.
examples::Picture DrawScene(Way way, const Scene& scene, Mistake mistake = Mistake::kNone);

// What a pixel shows if a point is kept that is on the kept side of all planes, or of any of them:
// decided pixel by pixel in world space, with nothing of clipc's.
enum class Kept { kByAll, kByAny };
examples::Picture DrawKept(const Scene& scene, Kept kept);

// Where pictures may differ: white within one pixel of where a plane cuts a surface that the other
// planes keep, whether it is seen or hidden; black elsewhere. From distances in world space, not
// from clip space.
examples::Picture DrawCuts(const Scene& scene);

// How far in pixels, at most for 99 % of the cuts, float arithmetic moves a cut in this scene when
// planes are in clip space: the largest ClipSpaceEdgeError.
double CutError(const Scene& scene);

}  // namespace clipc::scenes
