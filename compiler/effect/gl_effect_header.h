// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>

#include "compiler/effect/gl_effect.h"

namespace clipc {

// The text of a C header with the effect as `static const clipc_gl_effect_table NAME`, for
// effect-runtime/effect.h.
std::string GlEffectHeader(const GlEffect& effect, std::string_view name);

// The name for an effect of this file, "water.fx": water_effect.
std::string GlEffectName(std::string_view file);

}  // namespace clipc
