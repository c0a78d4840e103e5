// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/batch/permutations.h"

#include <cstdint>

#include <fmt/format.h>

namespace clipc {
namespace {

// The values of "{0,1,2}"; none if the text is not of that form.
std::vector<std::optional<std::string>> ListIn(std::string_view text) {
  if (text.size() < 2 || text.front() != '{' || text.back() != '}') return {};
  text = text.substr(1, text.size() - 2);
  std::vector<std::optional<std::string>> values(1, std::string());
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' || c == '[' || c == '{' ? 1 : c == ')' || c == ']' || c == '}' ? -1 : 0;
    if (depth < 0) return {};  // "{1},{2}"
    if (c == ',' && depth == 0) {
      values.emplace_back(std::string());
    } else {
      *values.back() += c;
    }
  }
  return values;
}

}  // namespace

std::string AsFileName(std::string_view text) {
  constexpr std::size_t kMost = 40;
  std::string name;
  for (const char c : text.substr(0, kMost)) {
    const bool is_plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
                          (c >= 'a' && c <= 'z') || c == '_' || c == '-';
    name += is_plain ? c : '_';
  }
  return name;
}

std::size_t ShaderGroup::Count() const {
  std::size_t count = 1;
  for (const MacroAxis& axis : axes) {
    if (count > kMaxPermutations) return SIZE_MAX;
    count *= axis.values.size();
  }
  return count;
}

std::vector<MacroAxis> TakeAxes(std::vector<std::string>& defines) {
  std::vector<MacroAxis> axes;
  std::erase_if(defines, [&](const std::string& define) {
    const std::size_t equals = define.find('=');
    if (equals == std::string::npos) return false;
    MacroAxis axis{define.substr(0, equals), ListIn(std::string_view(define).substr(equals + 1))};
    if (axis.values.empty()) return false;
    axes.push_back(std::move(axis));
    return true;
  });
  return axes;
}

std::vector<std::size_t> ChoicesOf(const ShaderGroup& group, std::size_t number) {
  std::vector<std::size_t> choices(group.axes.size());
  for (std::size_t i = choices.size(); i-- > 0;) {
    const std::size_t count = group.axes[i].values.size();
    choices[i] = number % count;
    number /= count;
  }
  return choices;
}

std::vector<std::string> DefinesOf(const ShaderGroup& group, std::size_t number) {
  const std::vector<std::size_t> choices = ChoicesOf(group, number);
  std::vector<std::string> defines;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const MacroAxis& axis = group.axes[i];
    if (const auto& value = axis.values[choices[i]])
      defines.push_back(fmt::format("{}={}", axis.macro, *value));
  }
  return defines;
}

std::string FileNameOf(const ShaderGroup& group, std::size_t number) {
  const std::vector<std::size_t> choices = ChoicesOf(group, number);
  std::string name = group.name;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const MacroAxis& axis = group.axes[i];
    const auto& value = axis.values[choices[i]];
    if (value && axis.values.size() > 1)
      name += fmt::format(".{}{}", AsFileName(axis.macro), AsFileName(*value));
  }
  return name;
}

std::string TitleOf(const ShaderGroup& group, std::size_t number) {
  std::string title = group.source;
  if (!group.label.empty()) title += ' ' + group.label;
  for (const std::string& define : DefinesOf(group, number)) title += ' ' + define;
  return title;
}

}  // namespace clipc
