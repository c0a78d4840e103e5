// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/gl_words.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "base/spelling.h"

namespace clipc {
namespace {

using ast::EffectValue;
using Kind = EffectValue::Kind;

struct GlWord {
  GlWords list;
  std::string_view word;
  std::uint32_t value;
};
constexpr GlWord kWords[] = {
#define GL_WORD(List, Word, Value) {GlWords::k##List, Word, Value},
#include "compiler/effect/gl_words.def"
};

// What the headers of Direct3D put before a word.
constexpr std::string_view kPrefixes[] = {"BLENDOP_",
                                          "BLEND_OP_",
                                          "BLEND_",
                                          "CMP_",
                                          "COMPARISON_",
                                          "STENCILOP_",
                                          "STENCIL_OP_",
                                          "FILL_",
                                          "CULL_",
                                          "TADDRESS_",
                                          "TEXTURE_ADDRESS_",
                                          "TEXF_",
                                          "DEPTH_WRITE_MASK_",
                                          "COLORWRITEENABLE_",
                                          "COLOR_WRITE_ENABLE_",
                                          "SHADE_",
                                          "FOG_",
                                          "MCS_",
                                          "TOP_",
                                          "ZB_"};

bool RemovePrefix(std::string_view& text, std::string_view prefix) {
  const bool is_there = text.starts_with(prefix);
  if (is_there) text.remove_prefix(prefix.size());
  return is_there;
}

bool AddNumbers(const EffectValue& value, std::vector<double>& to) {
  if (value.kind == Kind::kList)
    return std::ranges::all_of(value.parts,
                               [&](const EffectValue& part) { return AddNumbers(part, to); });
  to.push_back(value.number);
  return value.IsNumber();
}

}  // namespace

std::string PlainWord(std::string_view word) {
  const std::string upper = ToUpper(word);
  std::string_view rest = upper;
  const bool is_prefixed =
      RemovePrefix(rest, "D3D10_") || RemovePrefix(rest, "D3D11_") || RemovePrefix(rest, "D3D");
  if (is_prefixed) {
    (void)std::ranges::any_of(kPrefixes,
                              [&](std::string_view prefix) { return RemovePrefix(rest, prefix); });
  }
  std::string plain(rest);
  std::erase(plain, '_');
  return plain;
}

std::optional<std::uint32_t> ReadWord(GlWords list, const EffectValue& value) {
  if (value.kind != Kind::kWord) return std::nullopt;
  const std::string plain = PlainWord(value.word);
  const auto found = std::ranges::find_if(
      kWords, [&](const GlWord& row) { return row.list == list && row.word == plain; });
  return found == std::end(kWords) ? std::nullopt : std::optional(found->value);
}

std::vector<std::string_view> Words() {
  std::vector<std::string_view> words;
  for (const GlWord& row : kWords) words.push_back(row.word);
  return words;
}

std::optional<std::uint32_t> ReadMask(GlWords list, const EffectValue& value) {
  const auto parts =
      value.kind == Kind::kUnion ? std::span(value.parts) : std::span<const EffectValue>(&value, 1);
  std::uint32_t mask = 0;
  for (const EffectValue& part : parts) {
    const auto bits = part.IsNumber() ? ReadUnsigned(part) : ReadWord(list, part);
    if (!bits) return std::nullopt;
    mask |= *bits;
  }
  return mask;
}

std::optional<std::uint32_t> ReadUnsigned(const EffectValue& value) {
  constexpr double kMost = 9e18;  // fits 64 bits
  if (!value.IsNumber() || !(std::abs(value.number) < kMost)) return std::nullopt;
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(value.number));
}

std::optional<bool> ReadFlag(const EffectValue& value) {
  return value.IsNumber() ? std::optional(value.number != 0) : std::nullopt;
}

std::optional<std::vector<double>> ReadNumbers(const EffectValue& value) {
  std::vector<double> numbers;
  return AddNumbers(value, numbers) ? std::optional(std::move(numbers)) : std::nullopt;
}

std::uint32_t FloatBits(double value) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

}  // namespace clipc
