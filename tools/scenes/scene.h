// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "examples/shared/transform.h"
#include "runtime/matrix.h"
#include "runtime/table.h"

// The scene that is drawn through every lowering, on OpenGL and on Direct3D 9. No library, so that
// the Windows program has exactly the same numbers.
namespace clipc::scenes {

inline constexpr int kSize = 256;  // of the picture, in pixels, both ways

struct SceneVertex {
  float position[3];
  std::uint32_t color;  // 0xAARRGGBB, a D3DCOLOR
};

// Each object is one draw of a triangle list, in one color: what is inside of it cannot be told
// apart, so that only its outline and its cuts show.
struct Object {
  std::vector<SceneVertex> vertices;
  runtime::Matrix world;
};

struct Scene {
  std::vector<Object> objects;
  runtime::Matrix view;        // mirrored in the water
  runtime::Matrix projection;  // 0 <= z <= w
  // Kept is what is above the water and, of the scene with three, right of a wall and below a
  // slanted roof. World space.
  std::vector<runtime::Plane> planes;
};

// `plane_count` is 1 or 3.
Scene MakeScene(int plane_count);

// Mistakes that an application or a binding can make. A picture with one must be told from the
// right one.
enum class Mistake {
  kNone,
  kIndex,  // another plane's constants under the index of the first
  kSign,   // the first plane keeps its other side
  kSpace,  // the first plane as it is in world space
  kMask,   // the table does not enable its first plane
  // the table's first plane lies where its second one does; only a device that reads the table sees
  // that
  kOffset,
};
inline constexpr Mistake kMistakes[] = {Mistake::kIndex, Mistake::kSign, Mistake::kSpace,
                                        Mistake::kMask, Mistake::kOffset};
const char* NameOf(Mistake mistake);

// What goes to the constant buffer `Planes`: the planes in the clip space of `projection`, times
// `scale`, or what the mistake makes of them. kMask and kOffset leave them as they are.
std::array<runtime::Float4, 3> PlaneConstants(const Scene& scene, const runtime::Matrix& projection,
                                              double scale, Mistake mistake);

// What kMask and kOffset make of the table; else the table.
runtime::Table MistakenTable(runtime::Table table, Mistake mistake);

}  // namespace clipc::scenes
