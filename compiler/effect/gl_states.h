// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "compiler/effect/effect_facts.h"

namespace clipc {

// A state of a pass for OpenGL: clipc_gl_state and its value.
enum class GlStateKind : std::uint8_t {
#define GL_STATE(Enumerator, Name) k##Enumerator,
#include "compiler/effect/gl_states.def"
  kCount
};
std::string_view NameOf(GlStateKind kind);  // "DEPTH_TEST"

struct GlState {
  GlStateKind kind;
  std::uint32_t value = 0;
};

// The states of a pass, in the order of clipc_gl_state. `flips` says that the image is upside down,
// so that the front faces are the others. Reports what OpenGL does not have, and what depends on a
// parameter.
std::vector<GlState> ReadGlStates(const EffectFacts& effect, const ast::EffectPass& pass,
                                  bool flips, Diagnostics& diagnostics);

}  // namespace clipc
