// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "pixel/glsl_limits.h"

#include <algorithm>
#include <cstdint>
#include <map>

#include <fmt/format.h>

#include "pixel/names.h"

namespace clipc::pixel {
namespace {

constexpr int kMaxOperators = 4096;
constexpr std::uint64_t kMaxMembers = 1u << 16;

std::string WithoutComments(std::string_view text) {
  std::string code;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text.substr(at, 2) == "//") {
      at = text.find('\n', at);
    } else if (text.substr(at, 2) == "/*") {
      at = text.find("*/", at + 2);
      if (at != text.npos) ++at;
    } else {
      code += text[at];
      continue;
    }
    if (at >= text.size()) break;
    code += ' ';
  }
  return code;
}

// glslang walks its tree by recursion, and `a + a + ...` makes a tree as deep as it is long.
bool HasLongStatement(std::string_view code) {
  constexpr std::string_view kOperators = "+-*/%<>=&|^~!?:.([,";
  int operators = 0;
  for (const char c : code) {
    if (c == ';' || c == '{' || c == '}') operators = 0;
    if (kOperators.find(c) != std::string_view::npos && ++operators > kMaxOperators) return true;
  }
  return false;
}

// glslang walks the members of a struct wherever it stands, so that structs with two members of the
// struct before double the time. Counts a struct's members, those of its structs included.
bool HasLargeStruct(std::string_view code) {
  std::map<std::string_view, std::uint64_t> sizes;
  std::string_view last, name;  // the word before; the struct whose members are counted
  std::uint64_t size = 0, of_member = 1;
  const auto count_member = [&] { size = std::min(size + of_member, kMaxMembers + 1); };
  for (std::size_t at = 0; at < code.size();) {
    const std::size_t start = at;
    while (at < code.size() && IsWordCharacter(code[at])) ++at;
    if (const std::string_view word = code.substr(start, at - start); !word.empty()) {
      if (last == "struct") name = word, size = 0, of_member = 1;
      if (const auto known = sizes.find(word); known != sizes.end() && word != name)
        of_member = std::max(of_member, known->second);
      last = word;
      continue;
    }
    const char c = code[at++];
    if (c == ',' || c == ';') count_member();
    if (c == ';') of_member = 1;
    if (c == '}' && !name.empty()) {
      sizes[name] = std::max<std::uint64_t>(size, 1);
      name = {};
    }
    if (size > kMaxMembers && !name.empty()) return true;
  }
  return false;
}

}  // namespace

std::string GlslLimit(std::string_view text) {
  const std::string code = WithoutComments(text);
  if (HasLongStatement(code))
    return fmt::format("a statement has more than {} operators", kMaxOperators);
  if (HasLargeStruct(code)) return fmt::format("a struct has more than {} members", kMaxMembers);
  return {};
}

}  // namespace clipc::pixel
