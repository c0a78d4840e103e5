// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "runtime/matrix.h"
#include "runtime/table.h"

// The scene that is drawn with every lowering, on OpenGL and on Direct3D 9. It uses no library, so
// that the Windows program has exactly the same numbers.
namespace clipc::scenes {

inline constexpr int kSize = 256;  // the image's width and height in pixels

struct SceneVertex {
  float position[3];
  std::uint32_t color;  // 0xAARRGGBB, a D3DCOLOR
};

// Each object is one draw of a triangle list, in one color, so that only its outline and its cuts
// show.
struct Object {
  std::vector<SceneVertex> vertices;
  runtime::Matrix world;
};

struct Scene {
  std::vector<Object> objects;
  runtime::Matrix view;        // mirrored in the water
  runtime::Matrix projection;  // 0 <= z <= w
  // The planes in world space. They keep the points above the water and, if there are three, right
  // of a wall and below a slanted roof.
  std::vector<runtime::Plane> planes;
};

// Makes the scene with `plane_count` planes, 1 or 3.
Scene MakeScene(int plane_count);

// The constants of skinned.hlsl: bones that its indices and weights make into an object's matrix,
// without rounding, and lights that give each color as it is.
struct Skin {
  std::array<runtime::Matrix, 2> bones;
  runtime::Float4 indices, weights;
  std::array<runtime::Float4, 3> lights;
};
Skin SkinOf(const runtime::Matrix& matrix);

// Mistakes that an application or a binding can make. The image with one must differ from the
// right one.
enum class Mistake {
  kNone,
  kIndex,  // another plane's constants have the index of the first plane
  kSign,   // the first plane keeps its other side
  kSpace,  // the first plane is given in world space
  kMask,   // the table does not enable its first plane
  // The table has its first plane at the offset of its second one. Only a device that reads the
  // table shows it.
  kOffset,
};
inline constexpr Mistake kMistakes[] = {Mistake::kIndex, Mistake::kSign, Mistake::kSpace,
                                        Mistake::kMask, Mistake::kOffset};
const char* NameOf(Mistake mistake);

// The content of the constant buffer `Planes`: the planes in the clip space of `projection`, times
// `scale`, with the mistake. kMask and kOffset do not change them.
std::array<runtime::Float4, 3> PlaneConstants(const Scene& scene, const runtime::Matrix& projection,
                                              double scale, Mistake mistake);

// The table with the mistake. Only kMask and kOffset change it.
runtime::Table MistakenTable(runtime::Table table, Mistake mistake);

}  // namespace clipc::scenes
