// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/rules.h"

namespace clipc::rules {

// Makes the offsets of texture reads constants, as GLSL and Direct3D take them. HLSL lets an offset
// be computed from local variables that are set once and from counters of loops:
//
//   for (int i = -1; i < 1; ++i)                  sum += map.Gather(s, uv, int2(-1, 0));
//     sum += map.Gather(s, uv, int2(i, 0));   =>  sum += map.Gather(s, uv, int2(0, 0));
//
// Such offsets become literals, a `for` loop whose counter they depend on is unrolled, and a
// function with a parameter that they depend on is copied for the constants of its calls. Reports
// TextureOffsetNotConstant or TextureOffsetRange (fxc: X4566) where that does not help. The one
// offset of a Gather may stay unknown from shader model 5 on. Requires ResolveObjects.
void KnowOffsets(Program& program, Diagnostics& diagnostics);

}  // namespace clipc::rules
