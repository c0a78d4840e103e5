// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "frontend/signature/names.h"

namespace clipc::signature {

// The pieces of SV_ClipDistance, or of SV_CullDistance, on one side of a shader: one for each
// semantic index, and one array in GLSL.
class Distances {
 public:
  // Adds a piece: its components, each a float.
  void Add(std::uint32_t index, std::vector<ExprId> components, Span span) {
    pieces_.push_back({index, std::move(components), span});
  }
  bool empty() const { return pieces_.empty(); }
  // The place of the first piece; requires that there is one.
  Span span() const { return pieces_.front().span; }

  // The elements of the array in order: pieces in the order of their index, each within a register
  // of four as fxc packs a signature, so that two float3 are elements 0, 1, 2 and 4, 5, 6. An
  // element in a gap is none; without gaps the pieces follow each other.
  std::vector<ExprId> Packed(bool has_gaps);

  struct Piece {
    std::uint32_t index = 0;
    std::vector<ExprId> components;
    Span span;
  };
  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  std::vector<Piece> pieces_;
};

// The elements of GLSL's arrays of distances, and the components that Direct3D has at most, clip
// and cull together.
constexpr std::uint32_t kMaxDistances = 8;

// Whether the distances of a stage have the gaps that fxc leaves. Direct3D counts components, so
// that 8 of them may lie in more than two registers with gaps between them (vkd3d's
// clip-cull-distance.shader_test, checked against native). GLSL's arrays have 8 elements: such
// distances lie without gaps, in both stages alike.
bool FitWithGaps(Distances& clip, Distances& cull);

}  // namespace clipc::signature
