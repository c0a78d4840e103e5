// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "frontend/rules/names.h"

namespace clipc::rules {

// Checks the indices of arrays of textures, samplers and buffers. Up to shader model 5.0 reports
// those of a pixel shader that are not known when loops are unrolled (ObjectIndexNotLiteral). From
// 5.1 on warns of those that may differ between the vertices or pixels of a draw call and are not
// marked (ObjectIndexVaries), once for each array. Requires ResolveObjects and MarkNonUniform.
void CheckObjectIndices(const Program& program, Diagnostics& diagnostics);

}  // namespace clipc::rules
