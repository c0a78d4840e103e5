// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "link/glsl_limits.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "link/names.h"

namespace clipc::link {
namespace {

constexpr int kMaxOperators = 4096;
constexpr std::uint64_t kMaxStructMembers = 1u << 16;
constexpr std::uint64_t kMaxExpanded = 1u << 20;  // words and signs
constexpr int kMaxMacroDepth = 200;               // of macros that name each other

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

// An upper bound of the words and signs that a text has when its macros are expanded: a macro is
// taken to repeat each of its arguments as often as it has words. The bound saturates.
class ExpansionBound {
 public:
  explicit ExpansionBound(std::string_view code) {
    constexpr std::string_view kDefine = "define";
    for (std::size_t at = code.find('#'); at != code.npos; at = code.find('#', at + 1)) {
      if (code.substr(at, 2) == "##") pastes_ = true;
      std::size_t name = SkipSpace(code, at + 1);
      if (code.substr(name, kDefine.size()) != kDefine) continue;
      name = SkipSpace(code, name + kDefine.size());
      std::size_t body = name;
      while (body < code.size() && IsWordCharacter(code[body])) ++body;
      std::size_t end = body;
      while (end < code.size() && (code[end] != '\n' || code[end - 1] == '\\')) ++end;
      Macro& macro = macros_[code.substr(name, body - name)];
      macro.body += ' ';  // the bodies of all definitions, for any of them may hold
      macro.body += code.substr(body, end - body);
    }
  }

  // The bound of a text. A word that is pasted together may be the name of any macro.
  std::uint64_t OfAll(std::string_view code) {
    std::uint64_t heaviest = 1;
    for (const auto& [name, macro] : macros_) {
      if (pastes_) heaviest = std::max(heaviest, Weight(name, 0));
    }
    return Limited(Of(code, 0) * heaviest);
  }

 private:
  std::uint64_t Of(std::string_view text, int depth) {
    std::uint64_t total = 0, weight = 1, factor = 1;
    std::vector<std::uint64_t> outside;  // the factors around the open parentheses
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t start = at;
      while (at < text.size() && IsWordCharacter(text[at])) ++at;
      if (at > start) {
        weight = Weight(text.substr(start, at - start), depth);
        total = Limited(total + Limited(factor * weight));
        continue;
      }
      const char c = text[at++];
      if (c == ' ' || c == '\t' || c == '\n' || c == '\r') continue;
      total = Limited(total + factor);
      if (c == '(') {
        outside.push_back(factor);
        factor = Limited(factor * weight);
      } else if (c == ')' && !outside.empty()) {
        factor = outside.back();
        outside.pop_back();
      }
      weight = 1;
    }
    return total;
  }

  struct Macro {
    std::string body;
    std::uint64_t weight = 0;  // 0: not known yet
    bool is_under_way = false;
  };

  static std::uint64_t Limited(std::uint64_t count) { return std::min(count, kMaxExpanded + 1); }
  static std::size_t SkipSpace(std::string_view code, std::size_t at) {
    while (at < code.size() && (code[at] == ' ' || code[at] == '\t')) ++at;
    return at;
  }

  // The bound of a word. Macros that name each other in a circle, and pasted names, may be
  // anything.
  std::uint64_t Weight(std::string_view word, int depth) {
    const auto found = macros_.find(word);
    if (found == macros_.end()) return 1;
    Macro& macro = found->second;
    if (macro.is_under_way || depth > kMaxMacroDepth || (pastes_ && depth > 0))
      return kMaxExpanded + 1;
    if (macro.weight == 0) {
      macro.is_under_way = true;
      macro.weight = std::max<std::uint64_t>(Of(macro.body, depth + 1), 1);
      macro.is_under_way = false;
    }
    return macro.weight;
  }

  std::map<std::string_view, Macro> macros_;
  bool pastes_ = false;
};

// Whether a statement has too many operators: glslang walks its tree by recursion, and `a + a +
// ...` makes a tree as deep as it is long.
bool HasLongStatement(std::string_view code) {
  constexpr std::string_view kOperators = "+-*/%<>=&|^~!?:.([,";
  int operators = 0;
  for (const char c : code) {
    if (c == ';' || c == '{' || c == '}') operators = 0;
    if (kOperators.find(c) != std::string_view::npos && ++operators > kMaxOperators) return true;
  }
  return false;
}

// Whether a struct has too many members, those of its structs included: glslang walks the members
// of a struct wherever it is used, so that structs with two members of the struct before double the
// time.
bool HasLargeStruct(std::string_view code) {
  std::map<std::string_view, std::uint64_t> sizes;
  std::string_view last, name;  // the word before; the struct whose members are counted
  std::uint64_t size = 0, of_member = 1;
  const auto count_member = [&] { size = std::min(size + of_member, kMaxStructMembers + 1); };
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
    if (size > kMaxStructMembers && !name.empty()) return true;
  }
  return false;
}

}  // namespace

std::string GlslLimit(std::string_view text) {
  const std::string code = WithoutComments(text);
  if (ExpansionBound(code).OfAll(code) > kMaxExpanded)
    return fmt::format("its macros may make more than {} words of it", kMaxExpanded);
  if (HasLongStatement(code))
    return fmt::format("a statement has more than {} operators", kMaxOperators);
  if (HasLargeStruct(code))
    return fmt::format("a struct has more than {} members", kMaxStructMembers);
  return {};
}

}  // namespace clipc::link
