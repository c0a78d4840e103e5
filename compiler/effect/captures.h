// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "compiler/compile/facts.h"
#include "compiler/effect/effect_facts.h"

namespace clipc {

// Reads what ConstructGSWithSO captures of each stream, "0:POSITION.xyz; 1:TEXCOORD1.xy; $SKIP.x":
// "Stream-Output Stage" of Microsoft's documentation. `facts`, if not null, are those of the
// program, whose last stage before the pixels names the variables.
std::vector<EffectCaptureFact> ReadCaptures(const std::vector<std::string>& streams,
                                            const Facts* facts);

// Reports what is not an output, and what cannot capture: with `for_header` the header, and shaders
// for Vulkan.
void CheckCaptures(const EffectFacts& effect, bool for_header, Diagnostics& diagnostics);

}  // namespace clipc
