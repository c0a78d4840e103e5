// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ir/evaluate.h"
#include "ir/program.h"
#include "tools/draw/buffers.h"
#include "tools/draw/random_values.h"
#include "tools/draw/surface.h"
#include "tools/draw/textures.h"

namespace clipc::draw {

// A point for which a domain shader runs.
struct DomainPoint {
  std::uint32_t patch = 0;
  std::array<std::uint32_t, 3> at = {};  // SV_DomainLocation, the bits of floats
};
// The factors of each patch that a domain shader is tested with.
inline constexpr float kEdgeFactors[4] = {2, 3, 4, 2};
inline constexpr float kInsideFactors[2] = {3, 2};

// Random values for all that a shader reads.
struct RandomInputs {
  // By vertex, or by pixel of `surface`, then by index into Program::inputs.
  std::vector<std::vector<ir::IoBits>> vertices;
  Surface surface;  // of a pixel shader
  // Of a domain shader. Its vertices are control points; the constants of a patch are with the
  // first of it.
  std::vector<DomainPoint> points;
  std::vector<Bytes> cbuffers;  // by CbufferId
  Textures textures;
  Buffers buffers;
  std::uint32_t lanes = 8;  // of a wave

  // Answers the evaluator's read_object for `program`, and changes `own`, a vertex's copy of the
  // buffers: what a vertex writes no other may read, for nothing says which of them is first.
  void UseObject(const ir::Program& program, Buffers& own, const ir::ObjectRequest& request,
                 double undefined, std::span<std::uint64_t> result) const;
};

// Makes the inputs of one draw call. RandomInputs::vertices has instance after instance, each with
// the same attributes; or the pixels of a surface.
RandomInputs MakeRandomInputs(const ir::Program& program, const RandomOptions& options);

}  // namespace clipc::draw
