// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>

#include "frontend/check/entry_point.h"
#include "rewrite/distances.h"

namespace clipc::rewrite {

// Returns a function `name` that has the signature of the entry function, which is called `inner`
// by now, and calls it:
//
//   VsOut name(VsIn i, out float2 clipc_distances0 : SV_ClipDistance0)
//   {
//       VsOut clipc_result = inner(i);
//       clipc_distances0 = float2(dot(clipc_result.position, p0), dot(clipc_result.position, p1));
//       return clipc_result;
//   }
//
// The distances are the last outputs, so that the registers and locations of the others stay as
// they were: a struct that is returned comes before out parameters in DXC and glslang. A returned
// position comes after them in DXC, and is an out parameter here where there are others.
// It has the first `planes` planes.
std::string WriteWrapper(const EntryPoint& entry, const PlaneForm& form, const std::string& name,
                         const std::string& inner, std::size_t planes);

}  // namespace clipc::rewrite
