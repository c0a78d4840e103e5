// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "link/read.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "link/names.h"

namespace clipc::link {
namespace {

// Calls visit(word) for the words of a text, comments left out, until it returns true.
template <typename OnWord>
void ForEachWord(std::string_view text, OnWord&& visit) {
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '/' && text.substr(at, 2) == "//") {
      at = std::min(text.find('\n', at), text.size());
    } else if (text[at] == '/' && text.substr(at, 2) == "/*") {
      at = std::min(text.find("*/", at), text.size());
    } else if (IsWordCharacter(text[at])) {
      const std::size_t start = at;
      while (at < text.size() && IsWordCharacter(text[at])) ++at;
      if (visit(text.substr(start, at - start))) return;
      continue;
    }
    ++at;
  }
}

}  // namespace

Language LanguageOf(std::string_view bytes) {
  for (const std::string_view magic : {"\x03\x02\x23\x07", "\x07\x23\x02\x03"}) {
    if (bytes.starts_with(magic)) return Language::kSpirv;
  }
  const bool may_have_version = bytes.find("#version") != bytes.npos;
  bool is_hlsl = false, is_glsl = false, has_version = false;
  ForEachWord(bytes, [&](std::string_view word) {
    const auto is_one_of = [&](auto... names) { return ((word == names) || ...); };
    is_hlsl |= is_one_of("float2", "float3", "float4", "half4", "cbuffer", "SV_Target");
    is_glsl |= is_one_of("vec2", "vec3", "vec4", "gl_FragColor", "gl_FragCoord");
    has_version = may_have_version && word == "version";
    return has_version || (is_hlsl && !may_have_version);
  });
  return has_version || (is_glsl && !is_hlsl) ? Language::kGlsl : Language::kHlsl;
}

std::string Problem(const Interface& interface) {
  constexpr std::uint32_t kMaxLocation = 1024;
  std::set<std::uint32_t> taken;
  for (const Input& input : interface.inputs) {
    const std::uint32_t elements = input.type.Elements();
    if (elements == 0 || elements > kMaxElements)
      return fmt::format("{}: an input is an array of 1 to {} vectors", input.where, kMaxElements);
    if (input.location && *input.location > kMaxLocation)
      return fmt::format("{}: location {} is greater than {}", input.where, *input.location,
                         kMaxLocation);
    for (std::uint32_t i = 0; input.location && i < elements; ++i) {
      if (!taken.insert(*input.location + i).second)
        return fmt::format(
            "{}: location {} has another input; give each a location of its own, without "
            "`component`",
            input.where, *input.location + i);
    }
  }
  const auto is_numbered = [](const Input& input) { return input.location.has_value(); };
  if (!std::ranges::all_of(interface.inputs, is_numbered) &&
      std::ranges::any_of(interface.inputs, is_numbered))
    return "some inputs have a location and some have none";
  return {};
}

}  // namespace clipc::link
