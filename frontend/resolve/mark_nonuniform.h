// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/resolve/names.h"

namespace clipc::resolve {

// Moves NonUniformResourceIndex, which says that an index differs between invocations, to the
// places where a texture or buffer is chosen. GLSL wants it there, while HLSL's value may be kept
// in variables first:
//
//   uint i = NonUniformResourceIndex(n);     =>   uint i = n;
//   maps[i].Load(place)                           maps[NonUniformResourceIndex(i)].Load(place)
//
// Values are followed through variables, parameters and results. Afterwards the function is
// called only as the whole index of an array of textures, samplers or buffers, and there if
// anything in the index comes from a call of it. Requires ResolveObjects.
void MarkNonUniform(Program& program);

}  // namespace clipc::resolve
