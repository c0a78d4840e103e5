// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "compiler/effect/gl_states.h"
#include "frontend/parse/effect.h"

namespace clipc {

// The state of a sampler for OpenGL: a clipc_gl_effect_sampling.
struct GlSampling {
  std::uint32_t min_filter = 0, mag_filter = 0;
  std::array<std::uint32_t, 3> wrap = {};
  std::uint32_t compare_func = 0;  // 0: it does not compare
  double max_anisotropy = 1, min_lod = -1000, max_lod = 1000, lod_bias = 0;
  std::array<double, 4> border = {};
  friend bool operator==(const GlSampling&, const GlSampling&) = default;
};

constexpr std::uint32_t kGlNearest = 0x2600;

// What the states of a sampler mean. Those that are not given have the defaults of Direct3D 9, if
// the sampler `is_old`, or of Direct3D 10. Reports what OpenGL does not have.
GlSampling ReadGlSampling(const std::vector<ast::EffectState>& states, bool is_old,
                          StateReport& report);

// The name that a state gives: Map of `<Map>`, Maps[1] of `(Maps[1])`; empty for another value.
std::string NameIn(const ast::EffectState& state);
// The texture that the states name; empty: they name none.
std::string TextureOf(const std::vector<ast::EffectState>& states);

}  // namespace clipc
