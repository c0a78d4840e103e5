// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/discard.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace clipc::glsl {
namespace {

bool IsWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Words and single characters of GLSL, without comments and white space. A directive is one token,
// its line.
struct FragmentToken {
  std::string_view text;
  std::size_t begin = 0;  // byte offsets in the file
  std::size_t end = 0;
};

class FragmentScanner {
 public:
  explicit FragmentScanner(std::string_view text) : text_(text) {}

  std::vector<FragmentToken> All() {
    std::vector<FragmentToken> tokens;
    while (SkipSpace()) {
      const std::size_t begin = at_;
      if (text_[at_] == '#') {
        at_ = EndOfDirective();
      } else if (IsWordCharacter(text_[at_])) {
        while (at_ < text_.size() && IsWordCharacter(text_[at_])) ++at_;
      } else {
        ++at_;
      }
      tokens.push_back({text_.substr(begin, at_ - begin), begin, at_});
    }
    return tokens;
  }

 private:
  // To the next token; false at the end.
  bool SkipSpace() {
    while (at_ < text_.size()) {
      if (std::isspace(static_cast<unsigned char>(text_[at_]))) {
        ++at_;
      } else if (text_.substr(at_, 2) == "//") {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (text_.substr(at_, 2) == "/*") {
        const std::size_t end = text_.find("*/", at_ + 2);
        at_ = end == text_.npos ? text_.size() : end + 2;
      } else {
        return true;
      }
    }
    return false;
  }

  std::size_t EndOfDirective() const {
    std::size_t end = at_;
    do {
      end = std::min(text_.find('\n', end + 1), text_.size());
    } while (end < text_.size() && text_[end - 1] == '\\');
    return end;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

std::vector<std::string_view> WordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  for (const FragmentToken& token : FragmentScanner(line.substr(1)).All())
    words.push_back(token.text);
  return words;
}

// 110 and no profile when there is no #version line.
bool HasVersion(const std::vector<FragmentToken>& tokens, const Target& target) {
  std::vector<std::string_view> words;
  if (!tokens.empty() && tokens[0].text[0] == '#') words = WordsOf(tokens[0].text);
  if (words.size() < 2 || words[0] != "version") return false;
  const bool is_es = words.size() > 2 && words[2] == "es";
  return words[1] == std::to_string(target.version()) && is_es == target.IsEs();
}

// Behind #version and every #extension that stands before the first declaration, outside of #if.
std::size_t EndOfDirectives(const std::vector<FragmentToken>& tokens) {
  std::size_t end = 0;
  int depth = 0;
  for (const FragmentToken& token : tokens) {
    if (token.text[0] != '#') break;
    const std::vector<std::string_view> words = WordsOf(token.text);
    if (words.empty()) continue;
    if (words[0].starts_with("if")) ++depth;
    if (words[0] == "endif") --depth;
    if (depth == 0 && words[0] != "define") end = token.end;
  }
  return end;
}

// Where `{` of `void main()` ends; none unless there is exactly one.
std::optional<std::size_t> StartOfMain(const std::vector<FragmentToken>& tokens, int& count) {
  std::optional<std::size_t> start;
  for (std::size_t i = 0; i + 3 < tokens.size(); ++i) {
    if (tokens[i].text != "void" || tokens[i + 1].text != "main" || tokens[i + 2].text != "(")
      continue;
    std::size_t next = i + 3;
    if (next < tokens.size() && tokens[next].text == "void") ++next;
    if (next + 1 >= tokens.size() || tokens[next].text != ")" || tokens[next + 1].text != "{")
      continue;
    ++count;
    start = tokens[next + 1].end;
  }
  return count == 1 ? start : std::nullopt;
}

}  // namespace

DiscardCode WriteDiscard(const ir::Program& program, const Target& target, const GlslInfo& info,
                         const std::vector<std::string>& taken) {
  DiscardCode code;
  std::string tests;
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    if (program.outputs[i].semantic != ir::kClipPlaneDistance) continue;
    const GlslInfo::Variable& variable = info.outputs[i];
    const int count = program.types[program.vars[program.outputs[i].var].type].Components();
    const std::string type = count == 1 ? "float" : "vec" + std::to_string(count);
    if (variable.location)
      code.declarations += "layout(location = " + std::to_string(*variable.location) + ") ";
    code.declarations += target.Has(Feature::kInAndOut) ? "in " : "varying ";
    code.declarations += (target.IsEs() ? "highp " : "") + type + " " + variable.name + ";\n";
    const std::string kept =
        count == 1 ? variable.name + " >= 0.0"
                   : "all(greaterThanEqual(" + variable.name + ", " + type + "(0.0)))";
    tests += (tests.empty() ? "" : " && ") + kept;
  }
  if (tests.empty()) return code;
  code.function = "clip_planes";
  while (std::find(taken.begin(), taken.end(), code.function) != taken.end()) code.function += "_";
  code.declarations += "\nvoid " + code.function + "() {\n    if (!(" + tests + ")) discard;\n}\n";
  return code;
}

Insertion InsertDiscard(std::string_view fragment, const ir::Program& program, const Target& target,
                        const GlslInfo& info) {
  const std::vector<FragmentToken> tokens = FragmentScanner(fragment).All();
  if (!HasVersion(tokens, target)) {
    return {{}, "it does not start with `" + target.VersionLine() + "`, as the vertex shader does"};
  }
  int mains = 0;
  const std::optional<std::size_t> start = StartOfMain(tokens, mains);
  if (!start)
    return {{}, mains == 0 ? "it has no `void main() {`" : "it has more than one `void main() {`"};
  std::vector<std::string> taken;
  for (const FragmentToken& token : tokens) taken.emplace_back(token.text);
  const DiscardCode code = WriteDiscard(program, target, info, taken);
  if (code.function.empty()) return {std::string(fragment), {}};

  const std::size_t head = EndOfDirectives(tokens);
  Insertion result;
  result.text = std::string(fragment.substr(0, head)) + "\n\n" + code.declarations;
  result.text +=
      std::string(fragment.substr(head, *start - head)) + "\n    " + code.function + "();";
  result.text += fragment.substr(*start);
  return result;
}

}  // namespace clipc::glsl
