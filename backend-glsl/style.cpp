// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/style.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace clipc::glsl {
namespace {

struct Preset {
  std::string_view output, block, globals, constant_buffer;
};

// Sources: toGLSL.cpp of HLSLcc; DeclResultIdMapper.cpp of DXC, whose names have dots that
// SPIRV-Cross makes underscores; hlslParseHelper.cpp of glslang, which calls an input after the
// parameter, here `input`, and the field.
constexpr std::string_view kStyleNames[] = {"hlslcc", "dxc", "spirv-cross"};
constexpr Preset kStyles[] = {
    {"vs_{semantic}{index}", "{name}", "Globals", "{name}_block"},
    {"in_var_{written}", "type_{name}", "type_Globals", "type_ConstantBuffer_{type}"},
    {"input_{name}", "{name}", "_Global", "{name}"},
};

bool IsUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool IsLower(char c) { return c >= 'a' && c <= 'z'; }

}  // namespace

std::optional<NameStyle> NameStyle::Parse(std::string_view text) {
  for (std::size_t i = 0; i < std::size(kStyleNames); ++i) {
    if (text != kStyleNames[i]) continue;
    const auto& [output, block, globals, constant_buffer] = kStyles[i];
    return NameStyle{std::string(output), std::string(block), std::string(globals),
                     std::string(constant_buffer)};
  }
  const std::string filled =
      FillPattern(text, {{"semantic", "S"}, {"written", "S"}, {"name", "S"}, {"index", ""}});
  const std::string without =
      FillPattern(text, {{"semantic", ""}, {"written", ""}, {"name", ""}, {"index", ""}});
  if (filled == without || filled.find_first_of("{}") != filled.npos) return std::nullopt;
  NameStyle style;
  style.output = text;
  return style;
}

std::span<const std::string_view> NameStyle::Names() { return kStyleNames; }

std::string FillPattern(
    std::string_view pattern,
    std::initializer_list<std::pair<std::string_view, std::string_view>> values) {
  std::string text;
  while (!pattern.empty()) {
    const std::size_t open = std::min(pattern.find('{'), pattern.size());
    text += pattern.substr(0, open);
    pattern.remove_prefix(open);
    const std::size_t close = pattern.find('}');
    if (close == pattern.npos) break;
    const std::string_view place = pattern.substr(1, close - 1);
    const auto* value =
        std::ranges::find(values, place, &std::pair<std::string_view, std::string_view>::first);
    text += value == values.end() ? pattern.substr(0, close + 1) : value->second;
    pattern.remove_prefix(close + 1);
  }
  return text.append(pattern);
}

std::string InstanceName(std::string_view block) {
  std::string_view stem = block;
  const bool has_cb = stem.size() > 2 && (stem.starts_with("cb") || stem.starts_with("CB"));
  if (has_cb && IsUpper(stem[2]) && (stem.size() == 3 || IsLower(stem[3]) || IsLower(stem[0]))) {
    stem.remove_prefix(2);
  }
  // The capitals that the stem begins with become small, but for the one that begins the next word.
  std::string name(stem);
  for (std::size_t i = 0; i < name.size() && IsUpper(name[i]); ++i) {
    if (i > 0 && i + 1 < name.size() && IsLower(name[i + 1])) break;
    name[i] = static_cast<char>(name[i] - 'A' + 'a');
  }
  return name == block ? name + "_data" : name;
}

}  // namespace clipc::glsl
