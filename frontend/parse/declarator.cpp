// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "base/spelling.h"
#include "frontend/parse/parser.h"

// Declarators, which follow a type: name, dimensions, semantic, register, packoffset, annotation,
// initialiser.
namespace clipc::ast {
namespace {

// The number that `digits` spells; none unless all of its characters are digits of it.
std::optional<std::uint32_t> ParseNumber(std::string_view digits) {
  std::uint32_t number = 0;
  const char* const begin = digits.data();
  const char* const end = begin + digits.size();
  const auto [stopped, problem] = std::from_chars(begin, end, number);
  if (digits.empty() || problem != std::errc{} || stopped != end) return std::nullopt;
  return number;
}

// The number of a register name, 3 of `c3`; 0 of a letter alone, since `s[5]` is s5.
std::optional<std::uint32_t> NumberAfterLetter(std::string_view text) {
  if (text.empty()) return std::nullopt;
  return text.size() == 1 ? 0 : ParseNumber(text.substr(1));
}

// The number of a register name that other characters follow, 3 of `c3abc`; 0 of `banana`, since
// fxc reads no number there; none of other names.
std::optional<std::uint32_t> LetterAndNumber(std::string_view text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789", 1), text.size());
  if (text.empty()) return std::nullopt;
  if (end == 1) return ToLower(text[0]) == 'b' ? std::optional(0u) : std::nullopt;
  return ParseNumber(text.substr(1, end - 1));
}

}  // namespace

bool Parser::ParseDeclaratorName(Name& name, Span& span, std::string_view what) {
  if (At(kStar) || At(kAmp)) {
    Error(Here(), diag::NoPointers, At(kStar) ? "*" : "&");
    return false;
  }
  if (!At(kIdentifier)) {
    const bool is_called = At(kLeftParen) && pos_ > 0 && tokens_[pos_ - 1].kind == kIdentifier;
    const std::string_view before = is_called ? Text(tokens_[pos_ - 1].name()) : "";
    const bool is_attribute = is_called && MeaningOfAttribute(before) != AttributeMeaning::kUnknown;
    Unexpected(is_attribute ? fmt::format("brackets around the attribute, `[{}(...)]`", before)
                            : fmt::format("the name of a {}", what));
    return false;
  }
  // `int int1`: the name of a type with a size may be the name of something else.
  const std::string_view text = TextAt();
  const bool sized = AtWord(Word::kNumericType) && text.back() >= '1' && text.back() <= '4';
  const bool fixed_width = AtWord(Word::kNumericType) && text.ends_with("_t");
  if (IsReserved(WordAt()) && !(fixed_width || (sized && !At(kIdentifier, 1)))) {
    Error(Here(), diag::ReservedName, text, what);
    Next();
    return false;
  }
  span = Here();
  name = Next().name();
  return true;
}

VarDecl Parser::MakeVar(const Specifiers& specifiers) const {
  VarDecl var{};
  var.type = specifiers.type;
  var.qualifiers = specifiers.qualifiers;
  var.attributes = specifiers.attributes;
  return var;
}

// Parses all of a declarator after its name.
void Parser::ParseDeclaratorTail(VarDecl& var, Scope scope) {
  const std::size_t start = pos_;
  variable_ = {};
  var.dimensions = ParseDimensions();
  variable_.dimensions = {start, pos_};
  ParseColonParts(var);
  if (panic_) return;
  if (var.packoffset && scope != Scope::kBuffer)
    diagnostics_.Report(var.packoffset->span, diag::PackOffsetMisplaced);
  if (var.bit_width && scope != Scope::kStruct)
    diagnostics_.Report(file_.exprs[var.bit_width].span, diag::BitFieldMisplaced);
  const Name type = file_.types[var.type].name.name;
  const bool object = type && InfoOf(type).word == Word::kObjectType;
  if (AtStateBlock() && (scope != Scope::kLocal || object || AtStates())) {
    var.has_state_block = true;
    Accept(kEqual);
    if (AtWord(Word::kSamplerState)) Next();
    variable_.value.begin = pos_;
    SkipEffectBlock();
    variable_.value.end = pos_;
  } else if (Accept(kEqual)) {
    variable_.value.begin = pos_;
    ParseInitializer(var, scope);
    variable_.value.end = pos_;
  }
}

// Parses any number of annotations and of parts that follow a colon.
void Parser::ParseColonParts(VarDecl& var) {
  Collector registers(registers_);
  while ((At(kColon) || At(kLess)) && !panic_) {
    if (At(kLess)) {
      const std::size_t start = pos_;
      SkipAnnotation();
      variable_.annotations = {start, pos_};
    } else {
      ParseColonPart(var, registers);
    }
  }
  var.registers = registers.Finish();
}

// Parses `: SEMANTIC`, `: register(...)`, `: packoffset(...)` or the width of a bit-field.
void Parser::ParseColonPart(VarDecl& var, Collector<RegisterBinding>& registers) {
  Next();
  switch (WordAt()) {
    case Word::kRegister: registers.Add(ParseRegister()); return;
    case Word::kPackOffset: {
      const auto before = std::exchange(var.packoffset, ParsePackOffset());
      const auto& after = var.packoffset;
      if (before && after && (before->reg != after->reg || before->component != after->component))
        diagnostics_.Report(after->span, diag::PackOffsetOverridden)
            .Note(before->span, diag::FirstGivenHere);
      return;
    }
    default: break;
  }
  if (At(kIntLiteral)) {
    var.bit_width = ParseBinary(TraitsOf(BinaryOp::kAdd).precedence);
  } else if (At(kIdentifier) && At(kLeftParen, 1)) {
    Next();  // read(caller) and write(miss), of ray payloads
    SkipBalanced();
  } else {
    var.semantic = ParseSemantic();
  }
}

Semantic Parser::ParseSemantic() {
  if (!At(kIdentifier)) {
    Unexpected("a semantic, `register(...)` or `packoffset(...)`");
    return {};
  }
  Semantic semantic;
  semantic.span = Here();
  semantic.name = Next().name();
  return semantic;
}

void Parser::ParseInitializer(VarDecl& var, Scope scope) {
  const Name type = file_.types[var.type].name.name;
  const bool shader = type && InfoOf(type).is_shader_type && MeaningOf(type) == Meaning::kUnknown;
  constexpr Words kEffectWords(Word::kCompile, Word::kAsm, Word::kSamplerState);
  const bool effect_word = kEffectWords.Has(WordAt(At(kLeftBrace) ? 1 : 0));
  // A variable may have such a name; two names in a row do not make an expression.
  if (shader || (effect_word && (At(kIdentifier, 1) || At(kLeftBrace, 1)))) {
    var.has_state_block = true;
    SkipEffectValue();
  } else {
    var.init = ParseInitValue();
    if (std::exchange(list_has_effect_value_, false)) {
      // fxc takes such a list for a uniform, and gives it no values.
      if (scope == Scope::kLocal || (var.qualifiers & kStatic))
        diagnostics_.Report(var.name_span, diag::Unsupported,
                            "a value of the effects framework in the initialiser of a variable "
                            "that is not uniform");
      var.init = {};
      var.has_state_block = true;
    }
  }
}

// Parses a value of an initialiser. One of the effects framework, compile ps_4_0 f(), is skipped.
ExprId Parser::ParseInitValue() {
  if (At(kLeftBrace)) return ParseInitList();
  const bool is_block = AtWord(Word::kSamplerState) && At(kLeftBrace, 1);
  const bool is_shader = (AtWord(Word::kCompile) && At(kIdentifier, 1)) ||
                         (AtWord(Word::kCompileShader) && At(kLeftParen, 1));
  if (!is_block && !is_shader) return ParseAssignment();
  list_has_effect_value_ = true;
  const std::size_t start = pos_;
  is_block ? (Next(), SkipEffectBlock()) : SkipEffectValue();
  return AddExpr(start, ErrorExpr{});
}

// {a, {b, c},}
ExprId Parser::ParseInitList() {
  const std::size_t open = pos_;
  Nesting nesting(*this, 0);
  if (!nesting.ok()) return ErrorExprHere();
  Next();
  Bracketed bracketed(*this);
  Collector elements(exprs_);
  ParseList(kRightBrace, open, {}, [&] { elements.Add(ParseInitValue()); });
  return AddExpr(open, InitListExpr{elements.Finish()});
}

// register(c3), register(vs_5_0, b0), register(t0, space1), register(space2), register(c3[1])
RegisterBinding Parser::ParseRegister() {
  const std::size_t start = pos_;
  RegisterBinding binding;
  Next();
  const std::size_t open = pos_;
  if (!Expect(kLeftParen, "`(` after `register`")) return binding;
  while (ParseRegisterOperand(binding) && Accept(kComma)) {
  }
  Close(kRightParen, open);
  binding.span = SpanFrom(start);
  return binding;
}

// Parses one of the parts between the commas. Returns false after an error, which is reported.
bool Parser::ParseRegisterOperand(RegisterBinding& binding) {
  constexpr std::string_view kSpace = "space";
  constexpr std::string_view kLetters = "bcistu";
  std::string_view text = TextAt();
  // fxc takes cb1 for b1, as many public programs for Direct3D 11 write it.
  if (text.size() > 2 && ToLower(text.substr(0, 2)) == "cb") text.remove_prefix(1);
  if (ToLower(text.substr(0, kSpace.size())) == kSpace) {
    if (const auto number = ParseNumber(text.substr(kSpace.size()))) {
      binding.space = *number;
      binding.has_space = true;
      Next();
    } else {
      Error(Here(), diag::BadSpace, Describe());
    }
  } else if (const auto number = NumberAfterLetter(text);
             number && kLetters.find(ToLower(text[0])) != kLetters.npos) {
    binding.letter = ToLower(text[0]);
    binding.number = *number;
    Next();
    const std::size_t open = pos_;
    if (Accept(kLeftBracket)) {
      binding.subcomponent = ParseConditional();
      return ExpectClose(kRightBracket, open);
    }
  } else if (At(kIdentifier) && At(kComma, 1) && binding.letter == 0 && !binding.profile) {
    binding.profile = Next().name();
  } else if (At(kIdentifier) && At(kLeftBracket, 1) && At(kIntLiteral, 2) && At(kRightBracket, 3) &&
             At(kComma, 4) && binding.letter == 0 && !binding.profile) {
    for (int i = 0; i < 4; ++i) Next();
    binding.rest = RegisterBinding::Rest::kProfileNumber;
  } else if (const auto start = LetterAndNumber(text);
             start && kLetters.find(ToLower(text[0])) != kLetters.npos) {
    binding.letter = ToLower(text[0]);
    binding.number = *start;
    binding.rest = RegisterBinding::Rest::kText;
    Next();
  } else {
    Error(Here(), diag::BadRegister, Describe());
  }
  return !panic_;
}

// packoffset(c3), packoffset(c3.y), packoffset(c[3])
std::optional<PackOffset> Parser::ParsePackOffset() {
  const std::size_t start = pos_;
  Next();
  const std::size_t open = pos_;
  if (!Expect(kLeftParen, "`(` after `packoffset`")) return std::nullopt;
  PackOffset offset;
  if (!ParsePackOffsetOperand(offset)) Error(Here(), diag::BadPackOffset, Describe());
  const bool good = !panic_;
  Close(kRightParen, open);
  offset.span = SpanFrom(start);
  return good ? std::optional(offset) : std::nullopt;
}

// Parses `c3` or `c3.y`. Returns false if the current token does not belong there; reports nothing.
bool Parser::ParsePackOffsetOperand(PackOffset& offset) {
  const std::string_view text = TextAt();
  const auto number = NumberAfterLetter(text);
  if (!number || ToLower(text[0]) != 'c') return false;
  offset.reg = *number;
  Next();
  if (At(kLeftBracket) && At(kIntLiteral, 1) && At(kRightBracket, 2)) {
    Next();
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
    offset.reg = static_cast<std::uint32_t>(
        std::min(kMost, offset.reg + std::min(kMost, std::uint64_t{Next().value})));
    Next();
  }
  if (!Accept(kDot)) return true;
  const std::string_view component = TextAt();
  const std::size_t at = std::string_view("xyzwrgba").find(component);
  if (component.size() != 1 || at == component.npos) return false;
  offset.component = static_cast<std::uint32_t>(at % 4);
  Next();
  return true;
}

}  // namespace clipc::ast
