// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/resolve/registers.h"

namespace clipc::resolve {

// Follows every texture, sampler and buffer to its global variable, which GLSL wants, while HLSL
// passes them to functions, keeps them in local variables and structs, and returns them. Makes one
// copy of a function for each tuple of objects it is called with, and takes the objects out of
// parameters, variables and structs:
//
//   float4 Read(Maps maps, float2 uv) {             float4 Read(Maps maps, float2 uv) {
//     return maps.color.SampleLevel(                  return Color.SampleLevel(
//         maps.s, uv, maps.lod);                          Linear, uv, maps.lod);
//   }                                          =>   }
//   ...                                             ...
//   Maps maps; maps.color = Color;                  Maps maps;
//   maps.s = Linear; maps.lod = 0;                  maps.lod = 0;
//   Read(maps, uv);                                 Read(maps, uv);
//
// An index into an array of objects that is known only at run time becomes a variable of its own.
// Objects inside a uniform struct become resources. If the object is not the same on all paths
// it reports ObjectNotGlobal, as fxc (X3031) and DXC do. Afterwards an object occurs in an
// ObjectCall only, as the path of a resource.
void ResolveObjects(Program& program, const StructRegisters& registers, Diagnostics& diagnostics);

}  // namespace clipc::resolve
