// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/rules.h"

namespace clipc::rules {

// Makes the offsets of texture reads constants, as GLSL and Direct3D take them. HLSL lets an offset
// be computed from all that is known once functions are put in the place of their calls and loops
// are unrolled:
//
//   float4 Tap(float2 uv, int x) {                float4 Tap(float2 uv, int x) {  // for x = -1
//     return map.Gather(s, uv, int2(x, 0));         return map.Gather(s, uv, int2(-1, 0));
//   }                                        =>   }
//   ...                                           ...
//   Tap(uv, -1);                                  Tap(uv, -1);
//
// Such offsets become literals. A function is made anew for each tuple of known arguments that its
// offsets depend on, and a `for` loop whose counter they depend on is unrolled. Reports
// TextureOffsetNotConstant or TextureOffsetRange (fxc: X4566) where that does not help. The one
// offset of a Gather may stay unknown from shader model 5 on. Requires ResolveObjects.
void KnowOffsets(Program& program, Diagnostics& diagnostics);

}  // namespace clipc::rules
