// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/effect/gl_words.h"
#include "frontend/parse/effect_value.h"

// How the values of an effect's states are read: the columns of gl_states.def and d3d_states.def.
namespace clipc {

// Where a state is given: in a pass as in Direct3D 9, in a sampler, or in a block of Direct3D 10.
enum class StatePlace : std::uint8_t {
  kPass,
  kSampler,
  kBlendState,
  kDepthStencilState,
  kRasterizerState
};

// Whether two names are of one state: case and `_` do not count.
bool IsSameState(std::string_view a, std::string_view b);

// Reads a value for OpenGL; none: it is not a constant of that kind.
using ValueReading = std::optional<std::uint32_t> (*)(const ast::EffectValue& value);

inline constexpr std::uint32_t kClockwise = 0x900, kCounterclockwise = 0x901;

template <GlWords kList>
std::optional<std::uint32_t> Word(const ast::EffectValue& value) {
  return ReadWord(kList, value);
}
template <GlWords kList>
std::optional<std::uint32_t> Mask(const ast::EffectValue& value) {
  return ReadMask(kList, value);
}
inline std::optional<std::uint32_t> Chosen(const ast::EffectValue& value, std::uint32_t if_true,
                                           std::uint32_t if_false) {
  const std::optional<bool> flag = ReadFlag(value);
  return flag ? std::optional(*flag ? if_true : if_false) : std::nullopt;
}
inline std::optional<std::uint32_t> Flag(const ast::EffectValue& value) {
  return Chosen(value, 1, 0);
}
inline std::optional<std::uint32_t> NoFlag(const ast::EffectValue& value) {
  return Chosen(value, 0, 1);
}
// Triangles have all samples either way: MultisampleEnable of D3D11_RASTERIZER_DESC chooses how
// lines are drawn.
inline std::optional<std::uint32_t> OfLines(const ast::EffectValue& value) {
  return Chosen(value, 1, 1);
}
inline std::optional<std::uint32_t> FrontFace(const ast::EffectValue& value) {
  return Chosen(value, kCounterclockwise, kClockwise);
}
inline std::optional<std::uint32_t> DepthWrites(const ast::EffectValue& value) {
  return value.IsNumber() ? Flag(value) : ReadWord(GlWords::kDepthWrites, value);
}
inline std::optional<std::uint32_t> Scaled(const ast::EffectValue& value, double factor) {
  return value.IsNumber() ? std::optional(FloatBits(value.number * factor)) : std::nullopt;
}
inline std::optional<std::uint32_t> Float(const ast::EffectValue& value) {
  return Scaled(value, 1);
}
// Direct3D 9 gives a part of the depth range, OpenGL steps of a buffer of 24 bits.
inline std::optional<std::uint32_t> DepthPart(const ast::EffectValue& value) {
  return Scaled(value, 1 << 24);
}

// ---- what OpenGL does not have, so that only a word can be wrong

inline std::optional<std::uint32_t> Number(const ast::EffectValue& value) {
  return value.IsNumber() ? std::optional(0u) : std::nullopt;
}
// Nothing but the words of d3d_states.def, and numbers.
inline std::optional<std::uint32_t> NoWord(const ast::EffectValue& value) { return Number(value); }
inline std::optional<std::uint32_t> Anything(const ast::EffectValue&) { return 0; }
// The name of a variable, or NULL.
inline std::optional<std::uint32_t> Reference(const ast::EffectValue&) { return 0; }
// What the reader of effects takes for a shader wherever it stands.
inline std::optional<std::uint32_t> Shader(const ast::EffectValue&) { return 0; }

}  // namespace clipc
