// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/discard.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "backend-glsl/text.h"

namespace clipc::glsl {
namespace {

bool IsWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// The words and single characters of GLSL, without comments and white space, as parts of `text`. A
// directive is one token, its line.
std::vector<std::string_view> TokensOf(std::string_view text) {
  std::vector<std::string_view> tokens;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
    end = at + 1;
    if (text.substr(at, 2) == "//") {
      end = std::min(text.find('\n', at), text.size());
    } else if (text.substr(at, 2) == "/*") {
      end = std::min(text.find("*/", at + 2), text.size() - 2) + 2;
    } else if (text[at] == '#') {
      do {
        end = std::min(text.find('\n', end), text.size()) + 1;
      } while (end < text.size() && text[end - 2] == '\\');
      tokens.push_back(text.substr(at, --end - at));
    } else if (!std::isspace(static_cast<unsigned char>(text[at]))) {
      while (IsWordCharacter(text[at]) && end < text.size() && IsWordCharacter(text[end])) ++end;
      tokens.push_back(text.substr(at, end - at));
    }
  }
  return tokens;
}

// Whether the shader has the target's version. Without a #version line it has 110, or 100 of GLSL
// ES.
bool HasVersion(const std::vector<std::string_view>& tokens, const Target& target) {
  std::vector<std::string_view> words;
  if (!tokens.empty() && tokens[0][0] == '#') words = TokensOf(tokens[0].substr(1));
  if (words.size() < 2 || words[0] != "version") return target.version() == 100;
  const bool is_es = words[1] == "100" || (words.size() > 2 && words[2] == "es");
  return words[1] == std::to_string(target.version()) && is_es == target.IsEs();
}

// The rest of `text` after `part` of it.
std::string_view After(std::string_view text, std::string_view part) {
  return text.substr(static_cast<std::size_t>(part.data() + part.size() - text.data()));
}

// The text after #version and every #extension that comes before the first declaration, outside of
// #if.
std::string_view AfterDirectives(std::string_view text,
                                 const std::vector<std::string_view>& tokens) {
  std::string_view rest = text;
  int depth = 0;
  for (const std::string_view token : tokens) {
    if (token[0] != '#') break;
    const std::vector<std::string_view> words = TokensOf(token.substr(1));
    if (words.empty()) continue;
    if (words[0].starts_with("if")) ++depth;
    if (words[0] == "endif") --depth;
    if (depth == 0 && words[0] != "define") rest = After(text, token);
  }
  return rest;
}

// Whether a part of the text is inside of #if.
bool IsConditional(const std::vector<std::string_view>& tokens, std::string_view part) {
  int depth = 0;
  for (const std::string_view token : tokens) {
    if (token.data() >= part.data()) break;
    const auto words =
        token[0] == '#' ? TokensOf(token.substr(1)) : std::vector<std::string_view>();
    if (words.empty()) continue;
    if (words[0].starts_with("if")) ++depth;
    if (words[0] == "endif") --depth;
  }
  return depth > 0;
}

// The text after the `{` of each `void main() {`.
std::vector<std::string_view> AfterMains(std::string_view text,
                                         const std::vector<std::string_view>& tokens) {
  static constexpr std::string_view kShort[] = {"void", "main", "(", ")", "{"};
  static constexpr std::string_view kLong[] = {"void", "main", "(", "void", ")", "{"};
  std::vector<std::string_view> mains;
  std::span<const std::string_view> rest = tokens;
  const auto look = [&](const auto& head) {
    const std::size_t size = std::size(head);
    if (rest.size() < size || !std::ranges::equal(rest.first(size), head)) return;
    mains.push_back(After(text, rest[size - 1]));
  };
  for (; !rest.empty(); rest = rest.subspan(1)) {
    look(kShort);
    look(kLong);
  }
  return mains;
}

// The test whether one of the distances is below zero, or is not a number. GLSL gives comparisons
// with what is not a number no meaning, and drivers make `any(lessThan())` of
// `!all(greaterThanEqual())`: the second half is asked by itself.
std::string IsOutside(const std::string& distances, const std::string& type, const Target& target) {
  const bool has_isnan = target.Has(Feature::kRounding);
  if (type == "float") {
    const std::string is_nan = has_isnan ? "isnan({0})" : "{0} != {0}";
    return fmt::format(fmt::runtime(is_nan + " || {0} < 0.0"), distances);
  }
  const std::string is_nan = has_isnan ? "isnan({0})" : "notEqual({0}, {0})";
  return fmt::format(fmt::runtime("any(" + is_nan + ") || any(lessThan({0}, {1}(0.0)))"), distances,
                     type);
}

}  // namespace

DiscardCode WriteDiscard(const ir::Program& program, const Target& target, const GlslInfo& info,
                         const std::vector<std::string_view>& taken) {
  DiscardCode code;
  std::string tests;
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    if (program.outputs[i].semantic != ir::kClipPlaneDistance) continue;
    const GlslInfo::Variable& variable = info.outputs[i];
    const auto count = program.types[program.vars[program.outputs[i].var].type].Components();
    const std::string type = count == 1 ? "float" : fmt::format("vec{}", count);
    if (variable.location)
      code.declarations += fmt::format("layout(location = {}) ", *variable.location);
    if (target.IsEs() && !target.Has(Feature::kInAndOut)) {
      // Fragment shaders of OpenGL ES 2 need not have highp.
      code.declarations += fmt::format(
          "#ifdef GL_FRAGMENT_PRECISION_HIGH\nvarying highp {0} {1};\n#else\nvarying mediump {0} "
          "{1};\n#endif\n",
          type, variable.name);
    } else {
      Append(code.declarations, target.Has(Feature::kInAndOut) ? "in " : "varying ",
             target.IsEs() ? "highp " : "", type, " ", variable.name, ";\n");
    }
    tests += (tests.empty() ? "" : " || ") + IsOutside(variable.name, type, target);
  }
  if (tests.empty()) return code;
  code.function = "clip_planes";
  while (std::ranges::find(taken, code.function) != taken.end()) code.function += "_";
  code.declarations +=
      fmt::format("\nvoid {}() {{\n    if ({}) discard;\n}}\n", code.function, tests);
  return code;
}

Insertion InsertDiscard(std::string_view fragment, const ir::Program& program, const Target& target,
                        const GlslInfo& info) {
  const std::vector<std::string_view> tokens = TokensOf(fragment);
  if (!HasVersion(tokens, target)) {
    return {.error =
                "it does not start with `" + target.VersionLine() + "`, as the vertex shader does"};
  }
  const std::vector<std::string_view> mains = AfterMains(fragment, tokens);
  if (mains.empty()) return {.error = "it has no `void main() {`"};
  if (mains.size() > 1) return {.error = "it has more than one `void main() {`"};
  const DiscardCode code = WriteDiscard(program, target, info, tokens);
  if (code.function.empty()) return {.text = std::string(fragment)};

  const std::string_view rest = AfterDirectives(fragment, tokens), body = mains[0];
  std::string text =
      Concat(fragment.substr(0, fragment.size() - rest.size()), "\n\n", code.declarations,
             rest.substr(0, rest.size() - body.size()), "\n    ", code.function, "();");
  if (IsConditional(tokens, body)) {
    Append(text, "\n#define ", code.function, "_in_main\n", body, "\n#ifndef ", code.function,
           "_in_main\n#error the main that tests the clip planes is not compiled\n#endif\n");
  } else {
    text += body;
  }
  const bool tests_early = std::ranges::find(tokens, "early_fragment_tests") != tokens.end();
  return {.text = std::move(text), .tests_early = tests_early};
}

}  // namespace clipc::glsl
