// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clip-table/vocabulary.h"
#include "ir/program.h"

namespace clipc::rewrite {

// The semantic of the distances of lowering kDiscard, which the pixel shader reads.
inline constexpr std::string_view kPlaneDistance = "CLIP_PLANE_DISTANCE";

// How an entry's planes are written.
struct PlaneForm {
  Lowering lowering = Lowering::kClipDistance;  // or kNearPlane, kDiscard
  PlaneSpace space = PlaneSpace::kClip;
  ir::VarId position_input = {};  // the input with the position, for kObject
  // The least number of clip distances, for kClipDistance: those without a plane are 0, which keeps
  // everything.
  std::size_t distances = 0;
  // The location of the first distances of kDiscard, where [[vk::location]] gives those of the
  // other outputs: DXC wants it on all of them or on none.
  std::optional<std::uint32_t> location = {};
};

// A parameter with the distances to up to four planes: "float2 clipc_distances0 : SV_ClipDistance0"
// is `before` + type + name + semantic.
struct DistanceParameter {
  std::size_t first = 0, width = 0;
  std::string before, type, name, semantic;
};

// The parameters for `count` distances. Their names begin with `prefix`.
std::vector<DistanceParameter> DistanceParameters(const PlaneForm& form, const std::string& prefix,
                                                  std::size_t count);

}  // namespace clipc::rewrite
