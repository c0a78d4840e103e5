// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <charconv>

#include "frontend/parse/parser.h"

// What follows a type: name, dimensions, semantic, register, packoffset, annotation, initialiser.
namespace clipc::ast {
namespace {

char Lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// The number that is the whole of `digits`.
std::optional<std::uint32_t> ParseNumber(std::string_view digits) {
  std::uint32_t number = 0;
  const char* end = digits.data() + digits.size();
  auto [stopped, problem] = std::from_chars(digits.data(), end, number);
  if (digits.empty() || problem != std::errc{} || stopped != end) return std::nullopt;
  return number;
}

}  // namespace

bool Parser::ParseDeclaratorName(Name& name, Span& span, std::string_view what) {
  if (At(TokenKind::kStar) || At(TokenKind::kAmp)) {
    Error(Here(), diag::NoPointers, At(TokenKind::kStar) ? "*" : "&");
    return false;
  }
  if (!At(TokenKind::kIdentifier)) {
    Unexpected(fmt::format("the name of a {}", what));
    return false;
  }
  // `int int1`: names of types with a size are no keywords.
  const std::string_view text = Text(Peek().name());
  const bool sized = AtWord(Word::kNumericType) && text.back() >= '1' && text.back() <= '4';
  const bool fixed_width = AtWord(Word::kNumericType) && text.ends_with("_t");
  if (IsReserved(WordAt()) && !(fixed_width || (sized && Peek(1).kind != TokenKind::kIdentifier))) {
    Error(Here(), diag::ReservedName, text, what);
    Next();
    return false;
  }
  span = Here();
  name = Next().name();
  return true;
}

// Everything of a declarator behind its name.
void Parser::ParseDeclaratorTail(VarDecl& var, Scope scope) {
  var.dimensions = ParseDimensions();
  Collector<RegisterBinding> registers(register_stack_);
  while ((At(TokenKind::kColon) || At(TokenKind::kLess)) && !panic_) {
    if (At(TokenKind::kLess)) {
      SkipAnnotation();
    } else {
      ParseColonPart(var, registers);
    }
  }
  var.registers = registers.Finish(file_.registers);
  if (panic_) return;
  const Name type = file_.types[var.type].name.name;
  const bool object = type && InfoOfName(type).word == Word::kObjectType;
  if (AtStateBlock() && (scope != Scope::kLocal || object)) {
    var.has_state_block = true;
    Accept(TokenKind::kEqual);
    if (AtWord(Word::kSamplerState)) Next();
    SkipEffectBlock();
  } else if (Accept(TokenKind::kEqual)) {
    ParseInitializer(var);
  }
}

// `: SEMANTIC`, `: register(...)`, `: packoffset(...)` or the width of a bit-field.
void Parser::ParseColonPart(VarDecl& var, Collector<RegisterBinding>& registers) {
  Next();
  switch (WordAt()) {
    case Word::kRegister: registers.Add(ParseRegister()); return;
    case Word::kPackOffset: var.packoffset = ParsePackOffset(); return;
    default: break;
  }
  if (At(TokenKind::kIntLiteral)) {
    var.bit_width = ParseBinary(kAdditivePrecedence);
  } else if (At(TokenKind::kIdentifier) && Peek(1).kind == TokenKind::kLeftParen) {
    Next();  // read(caller), write(miss): of ray payloads
    SkipBalanced();
  } else {
    var.semantic = ParseSemantic();
  }
}

Semantic Parser::ParseSemantic() {
  if (!At(TokenKind::kIdentifier)) {
    Unexpected("a semantic, `register(...)` or `packoffset(...)`");
    return {};
  }
  Semantic semantic;
  semantic.span = Here();
  semantic.name = Next().name();
  return semantic;
}

void Parser::ParseInitializer(VarDecl& var) {
  const Name type = file_.types[var.type].name.name;
  const bool shader =
      type && InfoOfName(type).is_shader_type && MeaningOf(type) == Meaning::kUnknown;
  const Word word = WordAt(At(TokenKind::kLeftBrace) ? 1 : 0);
  const bool effect_word =
      word == Word::kCompile || word == Word::kAsm || word == Word::kSamplerState;
  // A variable may have such a name; two names in a row do not make an expression.
  if (shader || (effect_word && (Peek(1).kind == TokenKind::kIdentifier ||
                                 Peek(1).kind == TokenKind::kLeftBrace))) {
    var.has_state_block = true;
    SkipEffectValue();
  } else {
    var.init = ParseInitValue();
  }
}

ExprId Parser::ParseInitValue() {
  return At(TokenKind::kLeftBrace) ? ParseInitList() : ParseAssignment();
}

// {a, {b, c},}
ExprId Parser::ParseInitList() {
  const std::size_t open = pos_;
  Nesting nesting(*this, 0);
  if (!nesting.ok()) return ErrorExprHere();
  Next();
  Bracketed bracketed(*this);
  Collector<ExprId> elements(expr_stack_);
  while (!At(TokenKind::kRightBrace) && !AtEnd()) {
    elements.Add(ParseInitValue());
    if (panic_ || !Accept(TokenKind::kComma)) break;
  }
  if (!panic_ && !At(TokenKind::kRightBrace)) {
    Diagnostic* report = Error(Here(), diag::UnexpectedToken, Describe(), "`,` or `}`");
    if (report) report->Note(tokens_[open].span(), diag::OpenedHere, "{");
  }
  if (panic_)
    SkipToClose(TokenKind::kRightBrace);
  else
    Next();
  return AddExpr(open, InitListExpr{elements.Finish(file_.expr_lists)});
}

// register(c3), register(vs_5_0, b0), register(t0, space1), register(space2), register(c3[1])
RegisterBinding Parser::ParseRegister() {
  const std::size_t start = pos_;
  RegisterBinding binding;
  Next();
  const std::size_t open = pos_;
  if (!Expect(TokenKind::kLeftParen, "`(` after `register`")) return binding;
  while (ParseRegisterOperand(binding) && Accept(TokenKind::kComma)) {
  }
  if (!ExpectClose(TokenKind::kRightParen, open)) SkipToClose(TokenKind::kRightParen);
  binding.span = SpanFrom(start);
  return binding;
}

bool Parser::ParseRegisterOperand(RegisterBinding& binding) {
  if (!At(TokenKind::kIdentifier)) {
    Error(Here(), diag::BadRegister, Describe());
    return false;
  }
  const std::string_view text = Text(Peek().name());
  constexpr std::string_view kSpace = "space";
  if (text.starts_with(kSpace)) {
    const auto number = ParseNumber(text.substr(kSpace.size()));
    if (!number) {
      Error(Here(), diag::BadSpace, Describe());
      return false;
    }
    binding.space = *number;
    Next();
    return true;
  }
  constexpr std::string_view kLetters = "bcistu";
  // A letter alone is its register 0; `s[5]` is s5.
  const auto number = text.size() == 1 ? 0 : ParseNumber(text.substr(1));
  if (number && kLetters.find(Lower(text[0])) != std::string_view::npos) {
    binding.letter = Lower(text[0]);
    binding.number = *number;
    Next();
    if (!At(TokenKind::kLeftBracket)) return true;
    const std::size_t open = pos_;
    Next();
    binding.subcomponent = ParseConditional();
    return ExpectClose(TokenKind::kRightBracket, open);
  }
  if (Peek(1).kind == TokenKind::kComma && binding.letter == 0 && !binding.profile) {
    binding.profile = Next().name();
    return true;
  }
  Error(Here(), diag::BadRegister, Describe());
  return false;
}

// packoffset(c3), packoffset(c3.y), packoffset(c[3])
std::optional<PackOffset> Parser::ParsePackOffset() {
  const std::size_t start = pos_;
  Next();
  const std::size_t open = pos_;
  if (!Expect(TokenKind::kLeftParen, "`(` after `packoffset`")) return std::nullopt;
  PackOffset offset;
  if (!ParsePackOffsetOperand(offset)) Error(Here(), diag::BadPackOffset, Describe());
  const bool good = !panic_;
  if (!ExpectClose(TokenKind::kRightParen, open)) SkipToClose(TokenKind::kRightParen);
  offset.span = SpanFrom(start);
  return good ? std::optional(offset) : std::nullopt;
}

// False: the current token does not belong there.
bool Parser::ParsePackOffsetOperand(PackOffset& offset) {
  if (!At(TokenKind::kIdentifier)) return false;
  const std::string_view text = Text(Peek().name());
  const auto number = text.size() == 1 ? 0 : ParseNumber(text.substr(1));
  if (Lower(text[0]) != 'c' || !number) return false;
  offset.reg = *number;
  Next();
  if (At(TokenKind::kLeftBracket) && Peek(1).kind == TokenKind::kIntLiteral &&
      Peek(2).kind == TokenKind::kRightBracket) {
    Next();
    offset.reg += static_cast<std::uint32_t>(Next().value);
    Next();
  }
  if (!Accept(TokenKind::kDot)) return true;
  const std::string_view component = At(TokenKind::kIdentifier) ? Text(Peek().name()) : "";
  const std::size_t at = std::string_view("xyzwrgba").find(component);
  if (component.size() != 1 || at == std::string_view::npos) return false;
  offset.component = static_cast<std::uint32_t>(at % 4);
  Next();
  return true;
}

}  // namespace clipc::ast
