// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/parse/effect_value.h"

// What the values of an effect's states are for OpenGL. A function returns none for a value that is
// not a constant of the kind that it reads.
namespace clipc {

// The lists of words: a word may be in several, with another value in each.
enum class GlWords : std::uint8_t {
  kCompare,
  kFactor,
  kEquation,
  kStencil,
  kFill,
  kCullOrder,
  kCullFace,
  kDepthWrites,
  kChannel,
  kPlane,
  kWrap,
  kFilter
};

// The word as gl_words.def has it: `D3DBLEND_SRC_ALPHA`, `Src_Alpha` and `SRCALPHA` are one.
std::string PlainWord(std::string_view word);

// The words of all lists.
std::vector<std::string_view> Words();

// A word of the list.
std::optional<std::uint32_t> ReadWord(GlWords list, const ast::EffectValue& value);
// RED | GREEN, 0x7: words of the list and numbers.
std::optional<std::uint32_t> ReadMask(GlWords list, const ast::EffectValue& value);
// A number, of which the integral part counts, modulo 2^32.
std::optional<std::uint32_t> ReadUnsigned(const ast::EffectValue& value);
// A number that is 0 or not.
std::optional<bool> ReadFlag(const ast::EffectValue& value);
// The numbers in {float4(1, 0, 0, 1), 2}, one after another; all of them are numbers.
std::optional<std::vector<double>> ReadNumbers(const ast::EffectValue& value);

// The bits of a float.
std::uint32_t FloatBits(double value);

}  // namespace clipc
