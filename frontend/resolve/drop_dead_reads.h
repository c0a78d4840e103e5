// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/resolve/names.h"

namespace clipc::resolve {

// Removes what does not run, and texels that nothing uses, as far as constants tell: copies each
// function for the constants that its calls give, as fxc inlines every call, and empties those that
// nothing calls then. Shaders that pass one sampler for all features that are off are built so:
//
//   float4 Warp(float4 c, sampler warp, bool on) { if (on) c += tex1D(warp, c.x); return c; }
//   Warp(texCUBE(cubes, u), cubes, false)      =>      Warp(texCUBE(cubes, u))
//   ...                                                float4 Warp(float4 c) { return c; }
//
// Requires a program without errors that has `main`.
void DropDeadReads(Program& program);

}  // namespace clipc::resolve
