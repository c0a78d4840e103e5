// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>

#include "ir/program.h"

namespace clipc::passes {

// Makes a pixel shader discard what is outside of so many clip planes, whose distances the vertex
// shader of lowering kDiscard writes to outputs of four numbers each. The shader gets an input for
// each of those, of the semantic ir::kClipPlaneDistance. A distance that is not a number is
// outside.
//
//   color = tint;    =>    if (isnan(clip_plane_distance0) || clip_plane_distance0 < 0.0) discard;
//                          color = tint;
//
// Requires and ensures Form::kInlined.
void DiscardPlanes(ir::Program& program, std::size_t planes);

}  // namespace clipc::passes
