// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/resolve/names.h"

namespace clipc::resolve {

// Makes the offsets of texture reads constants, as GLSL and Direct3D take them. HLSL lets an offset
// be computed from local variables that are set once and from counters of loops:
//
//   for (int i = -1; i < 1; ++i)                  sum += map.Gather(s, uv, int2(-1, 0));
//     sum += map.Gather(s, uv, int2(i, 0));   =>  sum += map.Gather(s, uv, int2(0, 0));
//
// Such offsets become literals, a `for` loop whose counter they depend on is unrolled, and a
// function with a parameter that they depend on is copied for the constants of its calls. Reports
// TextureOffsetNotConstant or TextureOffsetRange (fxc: X4566) where that does not help. The one
// offset of a Gather may stay unknown from shader model 5 on. Does the same, as far as it can, for
// the indices of samplers in arrays, which OpenGL does not have. Requires ResolveObjects.
void KnowOffsets(Program& program, Diagnostics& diagnostics);

// Does the same, as far as it can, for the indices of textures and the like that local variables
// hold, before ResolveObjects: fxc unrolls the loop, and an index is a literal then.
//
//   Texture2D maps[2] = {first, second};
//   for (int i = 0; i < 2; ++i)                     sum += first.Sample(s, uv);
//     sum += maps[i].Sample(s, uv);             =>  sum += second.Sample(s, uv);
void KnowObjectIndices(Program& program, Diagnostics& diagnostics);

}  // namespace clipc::resolve
