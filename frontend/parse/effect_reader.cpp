// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/spelling.h"
#include "frontend/parse/effect.h"
#include "frontend/parse/keywords.h"

namespace clipc::ast {
namespace {

using enum TokenKind;
using TokenSpan = std::span<const Token>;

// Of brackets around one thing: more would be slow, and nobody writes them.
constexpr int kMostBrackets = 16;

// A statement of a pass or of a block of states.
struct Statement {
  NamedText text;       // the name is empty for a statement of no known form
  TokenSpan name = {};  // that, with its index
  TokenSpan value;      // after the `=`, or in the parentheses of a call
  bool is_call = false;
  Span span = {};
};

// The value of an expression of literals.
std::optional<std::int64_t> IntegerOf(TokenSpan tokens, const Names& names) {
  const EffectValue value = ReadEffectValue(tokens, names);
  const bool is_one = value.IsNumber() && value.is_integer && std::abs(value.number) < INT32_MAX;
  return is_one ? std::optional(static_cast<std::int64_t>(value.number)) : std::nullopt;
}

// Whether the tokens begin with a block of states: { Filter = LINEAR; }, or {}, which is not a list
// of values.
bool BeginsStates(TokenSpan tokens) {
  if (tokens.size() < 2 || tokens[0].kind != kLeftBrace) return false;
  return tokens[1].kind == kRightBrace ||
         (tokens.size() > 2 && tokens[1].kind == kIdentifier &&
          (tokens[2].kind == kEqual || tokens[2].kind == kLeftBracket));
}

class EffectReader {
 public:
  EffectReader(const Names& names, TokenSpan tokens) : names_(names), tokens_(tokens) {}

  // ---- techniques

  // Reads a technique, or a group of them.
  void ReadTechniques(std::vector<EffectTechnique>& techniques) {
    if (Word() != "fxgroup") return techniques.push_back(ReadTechnique({}));
    Take();
    const std::string group = TakeName();
    TakeAnnotations();
    if (At(kLeftBrace)) Take();
    while (!AtEnd() && !At(kRightBrace)) {
      if (Word().starts_with("technique")) {
        techniques.push_back(ReadTechnique(group));
      } else {
        Take();
      }
    }
  }

  // ---- parts of variables

  std::vector<Annotation> TakeAnnotations() {
    std::vector<Annotation> annotations;
    if (!At(kLess)) return annotations;
    Take();
    while (!AtEnd() && !At(kGreater)) {
      const TokenSpan all = TakeUntil(kGreater);
      if (At(kSemicolon)) Take();
      const auto equal = std::ranges::find(all, kEqual, &Token::kind);
      const TokenSpan left = all.first(static_cast<std::size_t>(equal - all.begin()));
      if (left.empty()) continue;
      const TokenSpan right = equal == all.end() ? TokenSpan() : all.subspan(left.size() + 1);
      annotations.push_back({Text(left.first(left.size() - 1)), Text(left.last(1)), Text(right)});
    }
    if (!AtEnd()) Take();
    return annotations;
  }

  // { Filter = LINEAR; ... }
  std::vector<EffectState> ReadStates() {
    std::vector<EffectState> states;
    if (At(kLeftBrace)) Take();
    while (!AtEnd() && !At(kRightBrace)) {
      if (auto statement = TakeStatement()) states.push_back(State(std::move(*statement)));
    }
    return states;
  }

  // { sampler_state { Filter = LINEAR; }, sampler_state { ... } }, or the same without the words.
  // The lists of several dimensions are one list.
  std::vector<std::vector<EffectState>> ReadElements() {
    std::vector<std::vector<EffectState>> elements;
    while (!AtEnd()) {
      if (BeginsStates(tokens_.subspan(pos_))) elements.push_back(ReadStates());
      if (!AtEnd()) Take();
    }
    return elements;
  }

  // A shader, or the elements of { a, b }.
  std::vector<EffectShader> ReadShaders() {
    if (!At(kLeftBrace)) return {ReadShader(tokens_)};
    std::vector<EffectShader> shaders;
    Take();
    while (!AtEnd() && !At(kRightBrace)) {
      const std::size_t start = pos_;
      int depth = 0;
      for (; !AtEnd() && !(depth == 0 && (At(kComma) || At(kRightBrace))); Take())
        depth += BracketStep(tokens_[pos_].kind);
      shaders.push_back(ReadShader(tokens_.subspan(start, pos_ - start)));
      if (At(kComma)) Take();
    }
    return shaders;
  }

  std::string Text(TokenSpan tokens) const { return TextOf(tokens, names_); }

  std::vector<Span> TakeUnended() { return std::exchange(unended_, {}); }

 private:
  bool AtEnd() const { return pos_ >= tokens_.size(); }
  bool At(TokenKind kind) const { return !AtEnd() && tokens_[pos_].kind == kind; }
  const Token& Take() { return tokens_[pos_++]; }
  std::string WordOf(const Token& token) const {
    return token.kind == kIdentifier ? ToLower(names_[token.name()]) : std::string();
  }
  std::string Word() const { return AtEnd() ? std::string() : WordOf(tokens_[pos_]); }
  std::string TakeName() {
    return At(kIdentifier) ? std::string(names_[Take().name()]) : std::string();
  }

  // Takes tokens up to a `;`, or an `end` outside of brackets.
  TokenSpan TakeUntil(TokenKind end) {
    const std::size_t start = pos_;
    for (int depth = 0; !AtEnd(); Take()) {
      if (depth == 0 && (At(kSemicolon) || At(end))) break;
      depth += BracketStep(tokens_[pos_].kind);
    }
    return tokens_.subspan(start, pos_ - start);
  }

  // Takes tokens up to a `;`, a `}`, or what begins the next statement: a name and `=` after those
  // of this one.
  TokenSpan TakeAssignment() {
    const std::size_t start = pos_;
    bool has_equal = false;
    for (int depth = 0; !AtEnd(); Take()) {
      if (depth == 0 && (At(kSemicolon) || At(kRightBrace))) break;
      const bool is_equal = depth == 0 && At(kEqual);
      if (is_equal && has_equal && tokens_[pos_ - 1].kind == kIdentifier) {
        --pos_;
        break;
      }
      has_equal = has_equal || is_equal;
      depth += BracketStep(tokens_[pos_].kind);
    }
    return tokens_.subspan(start, pos_ - start);
  }

  // Takes `Name = value;`, `Name[0] = value;` or `Name(value);`. None for a lone `;`.
  std::optional<Statement> TakeStatement() {
    const TokenSpan all = TakeAssignment();
    if (At(kIdentifier)) unended_.push_back(all.back().span());
    if (At(kSemicolon)) Take();
    if (all.empty()) return std::nullopt;
    const auto at = std::ranges::find_if(
        all, [](const Token& t) { return t.kind == kEqual || t.kind == kLeftParen; });
    const auto left = all.first(static_cast<std::size_t>(at - all.begin()));
    if (at == all.end() || left.empty() || left[0].kind != kIdentifier)
      return Statement{{{}, Text(all)}, {}, {}};
    const bool is_call = at->kind == kLeftParen;
    if (is_call && (all.back().kind != kRightParen || left.size() != 1))
      return Statement{{{}, Text(all)}, {}, {}};
    const TokenSpan value = all.subspan(left.size() + (is_call ? 0 : 1));
    return Statement{{Text(left), Text(value)},
                     left,
                     is_call ? value.subspan(1, value.size() - 2) : value,
                     is_call,
                     Cover(all.front().span(), all.back().span())};
  }

  EffectState State(Statement statement) const {
    EffectState state;
    state.name = std::move(statement.text.name);
    state.text = std::move(statement.text.value);
    if (!statement.name.empty()) state.word = Text(statement.name.first(1));
    state.has_index = statement.name.size() > 1;
    if (statement.name.size() == 4 && statement.name[2].kind == kIntLiteral)
      state.index = static_cast<std::uint32_t>(statement.name[2].value);
    state.value = statement.is_call ? ReadEffectArguments(statement.value, names_)
                                    : ReadEffectValue(statement.value, names_);
    state.span = statement.span;
    return state;
  }

  // technique10 Name <annotations> { pass ... }
  EffectTechnique ReadTechnique(const std::string& group) {
    EffectTechnique technique;
    technique.group = group;
    technique.kind = Word();
    Take();
    technique.name = TakeName();
    technique.annotations = TakeAnnotations();
    if (At(kLeftBrace)) Take();
    while (!AtEnd() && !At(kRightBrace)) {
      if (Word() == "pass") {
        technique.passes.push_back(ReadPass());
      } else {
        const TokenSpan other = TakeUntil(kRightBrace);
        if (At(kSemicolon)) Take();
        if (!other.empty()) technique.not_read.push_back(Text(other));
      }
    }
    if (!AtEnd()) Take();
    return technique;
  }

  // pass Name <annotations> { states }
  EffectPass ReadPass() {
    EffectPass pass;
    pass.span = Take().span();
    if (At(kIdentifier)) pass.span = tokens_[pos_].span();
    pass.name = TakeName();
    pass.annotations = TakeAnnotations();
    if (!At(kLeftBrace)) {
      pass.not_read.push_back(Text(TakeUntil(kRightBrace)));
      return pass;
    }
    Take();
    while (!AtEnd() && !At(kRightBrace)) {
      if (auto statement = TakeStatement()) AddStatement(pass, std::move(*statement));
    }
    pass.unended = TakeUnended();
    if (!AtEnd()) Take();
    return pass;
  }

  void AddStatement(EffectPass& pass, Statement statement) const {
    struct OfStage {
      std::string_view name;
      EffectShader EffectPass::* shader;
    };
    constexpr OfStage kOfStages[] = {
        {"vertexshader", &EffectPass::vertex}, {"hullshader", &EffectPass::hull},
        {"domainshader", &EffectPass::domain}, {"geometryshader", &EffectPass::geometry},
        {"pixelshader", &EffectPass::pixel},   {"computeshader", &EffectPass::compute}};
    std::string name = ToLower(statement.text.name);
    if (name.ends_with("shader") && name.starts_with("set")) name.erase(0, 3);
    const auto* const stage = std::ranges::find(kOfStages, name, &OfStage::name);
    if (name.empty()) {
      pass.not_read.push_back(std::move(statement.text.value));
    } else if (stage != std::end(kOfStages)) {
      pass.*stage->shader = ReadShader(statement.value);
    } else {
      pass.states.push_back(State(std::move(statement)));
    }
  }

  // Whether the tokens are in one pair of such brackets.
  static bool IsIn(TokenSpan tokens, TokenKind open, TokenKind close) {
    if (tokens.size() < 2 || tokens.front().kind != open || tokens.back().kind != close)
      return false;
    int depth = 0;
    for (const Token& token : tokens.first(tokens.size() - 1)) {
      depth += BracketStep(token.kind);
      if (depth == 0 && open != kLess) return false;
    }
    return true;
  }

  EffectShader ReadShader(TokenSpan tokens) const {
    using enum EffectShader::Kind;
    EffectShader shader;
    shader.text = Text(tokens);
    if (!tokens.empty()) shader.span = Cover(tokens.front().span(), tokens.back().span());
    // ((A[i])), <vs>
    for (int i = 0; i < kMostBrackets &&
                    (IsIn(tokens, kLeftParen, kRightParen) || IsIn(tokens, kLess, kGreater));
         ++i)
      tokens = tokens.subspan(1, tokens.size() - 2);
    const std::string word = tokens.empty() ? "null" : WordOf(tokens[0]);
    const bool is_zero = tokens.size() == 1 && tokens[0].kind == kIntLiteral && !tokens[0].value;
    if (word == "null" || is_zero) return shader;
    shader.kind = kOther;
    if (word == "compile" && tokens.size() > 2) {
      ReadCall(WordOf(tokens[1]), tokens.subspan(2), shader);
    } else if (word == "compileshader" && tokens.size() > 5 && tokens[3].kind == kComma &&
               IsIn(tokens.subspan(1), kLeftParen, kRightParen)) {
      ReadCall(WordOf(tokens[2]), tokens.subspan(4, tokens.size() - 5), shader);
    } else if (word == "constructgswithso" && IsIn(tokens.subspan(1), kLeftParen, kRightParen)) {
      ReadCaptures(tokens.subspan(2, tokens.size() - 3), shader);
    } else if (tokens[0].kind == kIdentifier && tokens.size() == 1) {
      shader.kind = kVariable;
      shader.variable = Text(tokens);
    } else if (tokens[0].kind == kIdentifier &&
               IsIn(tokens.subspan(1), kLeftBracket, kRightBracket)) {
      shader.kind = kVariable;
      shader.variable = Text(tokens.first(1));
      ReadIndex(tokens.subspan(2, tokens.size() - 3), shader);
    }
    return shader;
  }

  // CompileShader(gs_4_0, Main()), "0:POSITION.xyz; 1:NORMAL.xyz", with a text for each stream
  void ReadCaptures(TokenSpan arguments, EffectShader& shader) const {
    constexpr std::size_t kMostStreams = 4;
    std::size_t end = 0;
    for (int depth = 0; end < arguments.size(); ++end) {
      depth += BracketStep(arguments[end].kind);
      if (depth == 0 && arguments[end].kind == kComma) break;
    }
    if (end == 0 || WordOf(arguments[0]) != "compileshader") return;
    const EffectShader compiled = ReadShader(arguments.first(end));
    std::vector<std::string> captures;
    for (arguments = arguments.subspan(end); arguments.size() > 1 && arguments[0].kind == kComma;
         arguments = arguments.subspan(2)) {
      if (arguments[1].kind != kStringLiteral || captures.size() == kMostStreams) return;
      captures.emplace_back(names_[arguments[1].name()]);
    }
    if (compiled.kind != EffectShader::Kind::kCompiled || captures.empty() || !arguments.empty())
      return;
    shader.kind = compiled.kind;
    shader.profile = compiled.profile, shader.function = compiled.function;
    shader.call = compiled.call;
    shader.captures = std::move(captures);
  }

  // i, or T[i] with tables
  void ReadIndex(TokenSpan index, EffectShader& shader) const {
    constexpr std::size_t kMostTables = 4;
    while (index.size() > 3 && index[0].kind == kIdentifier && shader.tables.size() < kMostTables &&
           IsIn(index.subspan(1), kLeftBracket, kRightBracket)) {
      shader.tables.push_back(Text(index.first(1)));
      index = index.subspan(2, index.size() - 3);
    }
    for (int i = 0; i < kMostBrackets && IsIn(index, kLeftParen, kRightParen); ++i)
      index = index.subspan(1, index.size() - 2);
    shader.index = Text(index);
    std::erase(shader.index, ' ');
    if (const auto number = IntegerOf(index, names_)) shader.index = std::to_string(*number);
  }

  // Main(true, 4)
  void ReadCall(std::string profile, TokenSpan call, EffectShader& shader) const {
    const auto open = std::ranges::find(call, kLeftParen, &Token::kind);
    const auto name = call.first(static_cast<std::size_t>(open - call.begin()));
    const TokenSpan arguments = call.subspan(name.size());
    if (name.empty() || call.size() > kMaxCallTokens || !IsIn(arguments, kLeftParen, kRightParen))
      return;
    shader.kind = EffectShader::Kind::kCompiled;
    shader.profile = std::move(profile);
    for (const Token& token : name) shader.function += TextOf({&token, 1}, names_);
    if (arguments.size() > 2) shader.call = Text(call);
  }

  const Names& names_;
  TokenSpan tokens_;
  std::size_t pos_ = 0;
  std::vector<Span> unended_;
};

// Whether a value begins as that of a shader variable does.
bool IsShader(TokenSpan value, const Names& names) {
  if (!value.empty() && value[0].kind == kLeftBrace) value = value.subspan(1);
  if (value.size() < 2 || value[0].kind != kIdentifier) return false;
  const std::string word = ToLower(names[value[0].name()]);
  return word == "compileshader" || word == "constructgswithso" ||
         ((word == "compile" || word == "asm") && value[1].kind != kEqual);
}

// Whether a value is an array of blocks of states, each with or without the word sampler_state, in
// as many lists as the array has dimensions.
bool IsArrayOfStates(TokenSpan value) {
  bool is_list = false;
  while (!BeginsStates(value)) {
    if (value.size() < 2 || value[0].kind != kLeftBrace) return false;
    is_list = true;
    value = value.subspan(value[1].kind == kIdentifier ? 2 : 1);
  }
  return is_list;
}

// The type without the qualifiers that say nothing of it.
std::string TypeText(TokenSpan type, const Names& names) {
  constexpr std::string_view kLeft[] = {"uniform", "extern", "const", "shared", "static"};
  while (type.size() > 1 && type[0].kind == kIdentifier &&
         std::ranges::find(kLeft, names[type[0].name()]) != std::end(kLeft))
    type = type.subspan(1);
  return TextOf(type, names);
}

EffectParameter ReadParameter(const EffectVariable& variable, TokenSpan tokens,
                              const Names& names) {
  const auto part = [&](TokenRange range) {
    return tokens.subspan(range.begin, range.end - range.begin);
  };
  EffectParameter parameter;
  parameter.name = names[variable.name];
  parameter.type = TypeText(part(variable.type), names) + TextOf(part(variable.dimensions), names);
  if (variable.semantic) parameter.semantic = names[variable.semantic];
  parameter.annotations = EffectReader(names, part(variable.annotations)).TakeAnnotations();
  const TokenSpan value = part(variable.value);
  if (IsShader(value, names)) {
    parameter.shaders = EffectReader(names, value).ReadShaders();
  } else {
    EffectReader reader(names, value);
    parameter.is_block = BeginsStates(value);
    if (parameter.is_block) parameter.states = reader.ReadStates();
    if (IsArrayOfStates(value)) parameter.elements = reader.ReadElements();
    if (!parameter.is_block) parameter.value = TextOf(value, names);
    parameter.unended = reader.TakeUnended();
  }
  return parameter;
}

// The integers of {0, 1, -2}. None for a value of another form.
std::vector<std::int64_t> ReadTable(TokenSpan value) {
  if (value.size() < 3 || value.front().kind != kLeftBrace || value.back().kind != kRightBrace)
    return {};
  std::vector<std::int64_t> numbers;
  value = value.subspan(1, value.size() - 2);
  while (!value.empty()) {
    const bool is_negative = value[0].kind == kMinus;
    if (is_negative) value = value.subspan(1);
    if (value.empty() || value[0].kind != kIntLiteral) return {};
    const auto number =
        static_cast<std::int64_t>(std::min<std::uint64_t>(value[0].value, INT32_MAX));
    numbers.push_back(is_negative ? -number : number);
    value = value.subspan(1);
    if (!value.empty() && value[0].kind != kComma) return {};
    if (!value.empty()) value = value.subspan(1);
  }
  return numbers;
}

bool IsStatic(const EffectVariable& variable, TokenSpan tokens, const Names& names) {
  const TokenSpan type =
      tokens.subspan(variable.type.begin, variable.type.end - variable.type.begin);
  return std::ranges::any_of(type, [&](const Token& token) {
    return token.kind == kIdentifier && names[token.name()] == "static";
  });
}

}  // namespace

Effect ReadEffect(const File& file) {
  Effect effect;
  const TokenSpan tokens = file.effect->tokens;
  for (const TokenRange& range : file.effect->techniques) {
    EffectReader reader(file.names, tokens.subspan(range.begin, range.end - range.begin));
    reader.ReadTechniques(effect.techniques);
  }
  for (const EffectVariable& variable : file.effect->variables) {
    const TokenRange& range = variable.value;
    std::vector<std::int64_t> table =
        ReadTable(tokens.subspan(range.begin, range.end - range.begin));
    if (!table.empty() && variable.dimensions.begin != variable.dimensions.end)
      effect.tables.push_back({std::string(file.names[variable.name]), std::move(table)});
    const bool is_static = IsStatic(variable, tokens, file.names);
    if (is_static && variable.dimensions.begin == variable.dimensions.end) {
      if (const auto value =
              IntegerOf(tokens.subspan(range.begin, range.end - range.begin), file.names))
        effect.constants.push_back({std::string(file.names[variable.name]), *value});
    }
    EffectParameter parameter = ReadParameter(variable, tokens, file.names);
    // A static variable is not a parameter, but may hold a shader or a block of states.
    const bool is_data =
        parameter.shaders.empty() && !parameter.is_block && parameter.elements.empty();
    if (!is_data || !is_static) effect.parameters.push_back(std::move(parameter));
  }
  return effect;
}

}  // namespace clipc::ast
