// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <fmt/format.h>

#include "base/spelling.h"
#include "frontend/parse/attributes.h"
#include "frontend/parse/parser.h"

// Types, qualifiers and attributes.
namespace clipc::ast {
namespace {

// `dword` and `DWORD`, alone or with a size, are other spellings of `uint`.
bool IsDword(std::string_view text) {
  return text.starts_with("dword") || text.starts_with("DWORD");
}
std::string UintOfDword(std::string_view text) { return "uint" + std::string(text.substr(5)); }

}  // namespace

TypeId Parser::ParseType(bool may_define) {
  if (AtAnyOf(kTagWords)) return ParseTaggedType(may_define);
  if (AtWord(Word::kTypename)) Next();
  return ParseNamedType();
}

// `struct S`, or a definition.
TypeId Parser::ParseTaggedType(bool may_define) {
  const std::size_t start = pos_;
  const bool is_enum = AtWord(Word::kEnum);
  const bool is_name = AtName(1) && !At(kLeftBrace, 2) && !At(kColon, 2) && !At(kSemicolon, 2);
  if (is_name) {
    Next();
    return ParseNamedType();
  }
  if (!may_define) {
    Next();
    if (AtName()) return ParseNamedType();
    Unexpected("the name of a type");
    return AddType({SpanFrom(start), {}, {}, {}, false, {}});
  }
  DeclId definition;
  const std::uint32_t height =
      HeightOfDefinition([&] { definition = is_enum ? ParseEnum() : ParseStruct({}); });
  Type type{SpanFrom(start), {}, {}, definition, false, {}};
  type.name.name = NameOfType(definition);
  return AddType(type, height);
}

TypeId Parser::ParseNamedType() {
  const std::size_t start = pos_;
  Type type{};
  if (AtWord(Word::kUnsigned) && AtName(1) && AtName(2)) {  // `unsigned index_t x`
    Next();
    type.is_unsigned = true;
    type.name = ParseQualifiedName();
  } else if (AtWord(Word::kUnsigned)) {
    type.name.name = ParseUnsigned();
  } else if (AtName() || At(kColonColon) || AtWord(Word::kNumericType)) {
    type.name = ParseQualifiedName();
    Name& name = type.name.name;
    if (IsDword(Text(name)) && InfoOf(name).word == Word::kNumericType)
      name = Intern(UintOfDword(Text(name)));
  } else {
    Unexpected("a type");
  }
  if (At(kLess) && !panic_) {
    type.has_arguments = true;
    type.arguments = ParseTemplateArguments();
    while (At(kColonColon) && AtName(1) && !panic_) {
      Next();
      type.span = SpanFrom(start);
      const TypeId outer = AddType(type);
      type = {};
      type.outer = outer;
      type.name.name = Next().name();
      type.has_arguments = At(kLess);
      if (type.has_arguments) type.arguments = ParseTemplateArguments();
    }
  }
  type.span = SpanFrom(start);
  return AddType(type);
}

// `unsigned int`, `unsigned` -> uint; `unsigned min16int2` -> min16uint2; `unsigned dword` -> uint.
Name Parser::ParseUnsigned() {
  Next();
  if (!AtWord(Word::kNumericType)) return Intern("uint");
  std::string text(TextAt());
  if (IsDword(text)) text = UintOfDword(text);
  const std::size_t at = text.find("int");
  if (at == std::string::npos) {
    Unexpected("an integer type after `unsigned`");
    return Intern("uint");
  }
  Next();
  return Intern(at > 0 && text[at - 1] == 'u' ? text : text.substr(0, at) + "u" + text.substr(at));
}

QualifiedName Parser::ParseQualifiedName() {
  QualifiedName qualified;
  if (At(kIdentifier) && AtWord(Word::kNone) && !At(kColonColon, 1)) {
    qualified.name = Next().name();
    return qualified;
  }
  qualified.from_global = Accept(kColonColon);
  Collector scopes(name_lists_);
  while (true) {
    if (!AtName() && !AtWord(Word::kNumericType)) {
      Unexpected("a name");
      break;
    }
    qualified.name = Next().name();
    if (!At(kColonColon) || !At(kIdentifier, 1) || WordAt(1) == Word::kOperator) break;
    Next();
    scopes.Add(qualified.name);
  }
  qualified.scopes = scopes.Finish();
  return qualified;
}

// <float, 3>
List<ExprId> Parser::ParseTemplateArguments() {
  const std::size_t open = pos_;
  Next();
  Collector arguments(exprs_);
  Nesting nesting(*this);
  if (!nesting.ok()) return {};
  while (!At(kGreater) && !At(kGreaterGreater) && !AtEnd()) {
    arguments.Add(ParseTemplateArgument());
    if (panic_ || !Accept(kComma)) break;
  }
  if (!AcceptGreater()) ExpectClose(kGreater, open);
  return arguments.Finish();
}

ExprId Parser::ParseTemplateArgument() {
  const std::size_t start = pos_;
  Bracketed angles(*this, true);
  const Qualifiers qualifiers = ParseQualifiers(nullptr);
  if (pos_ > start || AtTypeArgument()) return ParseTypeOperand(qualifiers);
  return ParseConditional();
}

// Whether the template argument that starts here is a type. A name without a declaration is one if
// it has arguments of its own.
bool Parser::AtTypeArgument() const {
  const std::size_t after = SkipTypeName(0);
  if (StartsType(0)) {
    if (after == 0 || At(kLeftParen, after)) return after == 0;
  } else {
    if (!AtName() && !At(kColonColon)) return false;
    if (after > 1 && IsTypeName(after - 1)) return true;  // ns::T
  }
  const std::size_t name = LastOfQualifiedName(0);
  if (!At(kLess, name + 1)) return StartsType(0) && name == 0;
  const Meaning meaning = MeaningOf(Peek(name).name());
  if (meaning != Meaning::kType && meaning != Meaning::kUnknown) return false;
  if (WordAt() == Word::kTypename) return true;
  // S<T>::x is a value unless `typename` precedes it.
  const std::size_t close = SkipTemplateArguments(name + 1);
  return close == 0 || !At(kColonColon, close);
}

// Parses T or T[2], the operand of sizeof or a template argument.
ExprId Parser::ParseTypeOperand(Qualifiers qualifiers) {
  const std::size_t start = pos_;
  ExprId type = AddExpr(start, TypeExpr{ParseType(false), qualifiers});
  while (At(kLeftBracket) && !panic_) {
    const std::size_t open = pos_;
    Next();
    Bracketed bracketed(*this);
    const ExprId size = ParseConditional();
    ExpectClose(kRightBracket, open);
    type = AddExpr(start, IndexExpr{type, size});
  }
  return type;
}

// Parses qualifiers in any order, with attributes between them if the caller takes attributes.
Qualifiers Parser::ParseQualifiers(Collector<Attr>* attributes) {
  Qualifiers qualifiers = 0;
  while (!AtEnd()) {
    if (attributes && AtWord(Word::kLayout) && At(kLeftParen, 1)) {
      ParseAttribute(*attributes, pos_);
    } else if (IsQualifier(0)) {
      const Qualifiers added = InfoOf(Peek().name()).qualifier;
      if (added & qualifiers & (kIn | kOut))  // fxc X3048, "duplicate usages specified"
        diagnostics_.Report(Peek().span(), diag::QualifierTwice, SpellingsOf(added)[0]);
      Next();
      qualifiers |= added;
    } else if (attributes && At(kLeftBracket) && !panic_) {
      ParseAttributes(*attributes);
    } else {
      break;
    }
  }
  return qualifiers;
}

List<Attr> Parser::ParseAttributes() {
  Collector attributes(attrs_);
  ParseAttributes(attributes);
  return attributes.Finish();
}

// Parses any number of `[name]`, `[name(arguments)]`, `[a, b]` and `[[ns::name(arguments)]]`.
void Parser::ParseAttributes(Collector<Attr>& attributes) {
  while (At(kLeftBracket) && !panic_) ParseAttributeList(attributes);
}

void Parser::ParseAttributeList(Collector<Attr>& attributes) {
  const std::size_t start = pos_;
  Next();
  const bool doubled = Accept(kLeftBracket);
  while (!At(kRightBracket) && !AtEnd()) {
    if (!ParseAttribute(attributes, start) || !Accept(kComma)) break;
  }
  if (doubled) ExpectClose(kRightBracket, start + 1);
  ExpectClose(kRightBracket, start);
  if (panic_) SkipToClose(kRightBracket);
}

bool Parser::ParseAttribute(Collector<Attr>& attributes, std::size_t start) {
  const std::size_t name_at = pos_;
  if (!At(kIdentifier)) {
    Unexpected("the name of an attribute");
    return false;
  }
  Attr attribute;
  attribute.name = Next().name();
  while (At(kColonColon) && At(kIdentifier, 1)) {
    Next();
    attribute.name = Intern(fmt::format("{}::{}", Text(attribute.name), Text(Next().name())));
  }
  attribute.name_span = SpanFrom(name_at);
  if (At(kLeftParen)) {
    attribute.has_parens = true;
    attribute.arguments = ParseArguments();
  }
  const bool doubled = tokens_[start + 1].kind == kLeftBracket;
  const std::size_t last = doubled && At(kRightBracket, 1) ? 1 : 0;
  attribute.span =
      At(kRightBracket) ? Cover(tokens_[start].span(), Peek(last).span()) : SpanFrom(start);
  attributes.Add(attribute);
  NoteAttribute(attribute);
  return !panic_;
}

void Parser::NoteAttribute(const Attr& attribute) {
  const AttributeMeaning meaning = MeaningOfAttribute(Text(attribute.name));
  file_.has_later_stage |= meaning == AttributeMeaning::kLaterStage;
  const bool is_unknown = meaning == AttributeMeaning::kUnknown;
  if (!is_unknown && meaning != AttributeMeaning::kWithoutEffect) return;
  if (noted_attributes_.size() <= attribute.name.index) noted_attributes_.resize(names_.size());
  if (noted_attributes_[attribute.name.index]) return;
  noted_attributes_[attribute.name.index] = true;
  Diagnostic& report = diagnostics_.Report(
      attribute.name_span, is_unknown ? diag::AttributeUnknown : diag::AttributeWithoutEffect,
      Text(attribute.name));
  if (EqualIgnoringCase(Text(attribute.name), "layout"))
    report.Note(attribute.name_span, diag::LayoutOfGlsl);
}

void Parser::CheckAttributes(List<Attr> attributes, AttributeOwner owner, std::string_view what) {
  for (const Attr& attribute : file_.attrs[attributes]) {
    const std::string_view name = Text(attribute.name);
    if (owner != AttributeOwner::kFunction) {
      const AttributeMeaning meaning = MeaningOfAttribute(name);
      if (meaning == AttributeMeaning::kClipPlanes || meaning == AttributeMeaning::kLikeClipPlanes)
        diagnostics_.Report(attribute.span, diag::ClipPlanesMisplaced, name, what);
    }
    const auto vulkan = VulkanAttributeOf(name);
    if (vulkan && !MayStandAt(*vulkan, owner))
      diagnostics_.Report(attribute.name_span, diag::AttributeMisplaced, name, what);
  }
}

// Reports the qualifiers that do not belong at a declaration of `owner`, at the span of its name.
void Parser::CheckQualifiers(Qualifiers qualifiers, QualifierOwner owner, Span span) {
  if (qualifiers == 0) return;
  for (const std::string_view word : SpellingsOf(RefusedAt(owner, qualifiers))) {
    const bool is_glsl = owner == QualifierOwner::kGlobal && (word == "in" || word == "out");
    diagnostics_.Report(span, diag::QualifierMisplaced, TextOf(owner), word,
                        is_glsl ? "; this is as in GLSL, and clipc reads HLSL" : "");
  }
  for (const std::string_view word : SpellingsOf(WithoutEffectAt(owner, qualifiers)))
    diagnostics_.Report(span, diag::QualifierWithoutEffect, word, TextOf(owner));
  const auto [first, second] = ConflictIn(qualifiers);
  if (first != 0)
    diagnostics_.Report(span, diag::QualifierConflict, SpellingsOf(first)[0],
                        SpellingsOf(second)[0]);
  if ((qualifiers & kCentroid) && (qualifiers & kSample))
    diagnostics_.Report(span, diag::CentroidOverridden);
  if ((qualifiers & kNoInterpolation) && (qualifiers & kSample))
    diagnostics_.Report(span, diag::SampleOverridden);
}

// Parses any number of `[n]` and `[]`.
List<ExprId> Parser::ParseDimensions() {
  Bracketed bracketed(*this);
  Collector dimensions(exprs_);
  while (At(kLeftBracket) && !panic_) {
    const std::size_t open = pos_;
    Next();
    dimensions.Add(At(kRightBracket) ? ExprId{} : ParseConditional());
    Close(kRightBracket, open);
  }
  return dimensions.Finish();
}

}  // namespace clipc::ast
