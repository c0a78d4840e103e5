// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "compiler/effect/effect_facts.h"

namespace clipc {

// The document that describes an effect: docs/effects.md.
std::string EffectJson(const EffectFacts& facts);

}  // namespace clipc
