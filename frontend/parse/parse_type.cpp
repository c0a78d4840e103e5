// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <utility>

#include "frontend/parse/parser.h"

// Types, qualifiers and attributes.
namespace clipc::ast {

// `height_of_definition`: nodes on the longest path of a struct defined on the spot.
TypeId Parser::AddType(Type type, std::uint32_t height_of_definition) {
  std::uint32_t height =
      1 + std::max({HeightOf(type.arguments), HeightOf(type.outer), height_of_definition});
  if (!CheckHeight(height, type.span)) {
    type = {};
    height = 1;
  }
  type_heights_.push_back(height);
  return file_.types.Add(type);
}

// `may_define`: `struct {...}` may stand here.
TypeId Parser::ParseType(bool may_define) {
  switch (WordAt()) {
    case Word::kStruct:
    case Word::kClass:
    case Word::kInterface:
    case Word::kEnum: return ParseTaggedType(may_define);
    case Word::kTypename: Next(); break;
    default: break;
  }
  return ParseNamedType();
}

// `struct S`, or a definition.
TypeId Parser::ParseTaggedType(bool may_define) {
  const std::size_t start = pos_;
  const bool is_enum = AtWord(Word::kEnum);
  const TokenKind behind = Peek(2).kind;
  const bool elaborated = AtName(1) && behind != TokenKind::kLeftBrace &&
                          behind != TokenKind::kColon && behind != TokenKind::kSemicolon;
  if (elaborated && !(is_enum && WordAt(1) == Word::kClass)) {
    Next();
    return ParseNamedType();
  }
  if (!may_define) {
    Next();
    if (AtName()) return ParseNamedType();
    Unexpected("the name of a type");
    return AddType({SpanFrom(start), {}, {}, {}, false, {}});
  }
  const int outer_deepest = std::exchange(deepest_, depth_);
  const std::uint32_t outer_tallest = std::exchange(tallest_, 0);
  const DeclId definition = is_enum ? ParseEnum() : ParseStruct({});
  Type type{SpanFrom(start), {}, {}, definition, false, {}};
  type.name.name = is_enum ? std::get<EnumDecl>(file_.decls[definition].node).name
                           : std::get<StructDecl>(file_.decls[definition].node).name;
  const TypeId id = AddType(type, static_cast<std::uint32_t>(deepest_ - depth_) + tallest_);
  deepest_ = std::max(deepest_, outer_deepest);
  tallest_ = std::max(tallest_, outer_tallest);
  return id;
}

TypeId Parser::ParseNamedType() {
  const std::size_t start = pos_;
  Type type{};
  if (AtWord(Word::kUnsigned)) {
    type.name.name = ParseUnsigned();
  } else if (AtName() || At(TokenKind::kColonColon) || AtWord(Word::kNumericType)) {
    type.name = ParseQualifiedName();
    const std::string_view text = Text(type.name.name);
    // `dword` and `DWORD` are uint in another spelling, sizes included.
    if ((text.starts_with("dword") || text.starts_with("DWORD")) &&
        InfoOfName(type.name.name).word == Word::kNumericType) {
      type.name.name = Intern("uint" + std::string(text.substr(5)));
    }
  } else {
    Unexpected("a type");
  }
  if (At(TokenKind::kLess) && !panic_) {
    type.has_arguments = true;
    type.arguments = ParseTemplateArguments();
    while (At(TokenKind::kColonColon) && AtName(1) && !panic_) {
      Next();
      type.span = SpanFrom(start);
      const TypeId outer = AddType(type);
      type = {};
      type.outer = outer;
      type.name.name = Next().name();
      type.has_arguments = At(TokenKind::kLess);
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
  const std::string text(Text(Peek().name()));
  const std::size_t at = text.find("int");
  const bool dword = text.starts_with("dword") || text.starts_with("DWORD");
  if (at == std::string::npos && !dword) {
    Unexpected("an integer type after `unsigned`");
    return Intern("uint");
  }
  Next();
  if (dword) return Intern("uint" + text.substr(5));
  return Intern(at > 0 && text[at - 1] == 'u' ? text : text.substr(0, at) + "u" + text.substr(at));
}

QualifiedName Parser::ParseQualifiedName() {
  QualifiedName qualified;
  if (At(TokenKind::kIdentifier) && AtWord(Word::kNone) && Peek(1).kind != TokenKind::kColonColon) {
    qualified.name = Next().name();
    return qualified;
  }
  qualified.from_global = Accept(TokenKind::kColonColon);
  Collector<Name> scopes(name_stack_);
  while (true) {
    if (!AtName() && !AtWord(Word::kNumericType)) {
      Unexpected("a name");
      break;
    }
    qualified.name = Next().name();
    if (!At(TokenKind::kColonColon) || Peek(1).kind != TokenKind::kIdentifier ||
        WordAt(1) == Word::kOperator)
      break;
    Next();
    scopes.Add(qualified.name);
  }
  qualified.scopes = scopes.Finish(file_.name_lists);
  return qualified;
}

// <...>, at its `<`.
List<ExprId> Parser::ParseTemplateArguments() {
  const std::size_t open = pos_;
  Next();
  Collector<ExprId> arguments(expr_stack_);
  Nesting nesting(*this);
  if (!nesting.ok()) return {};
  while (!At(TokenKind::kGreater) && !At(TokenKind::kGreaterGreater) && !AtEnd()) {
    arguments.Add(ParseTemplateArgument());
    if (panic_ || !Accept(TokenKind::kComma)) break;
  }
  switch (Peek().kind) {
    case TokenKind::kGreater:
    case TokenKind::kGreaterGreater:
    case TokenKind::kGreaterEqual:
    case TokenKind::kGreaterGreaterEqual: SplitGreater(); break;
    default: ExpectClose(TokenKind::kGreater, open); break;
  }
  return arguments.Finish(file_.expr_lists);
}

ExprId Parser::ParseTemplateArgument() {
  const std::size_t start = pos_;
  Bracketed angles(*this, true);
  ParseQualifiers(nullptr);
  if (pos_ > start || AtTypeArgument()) return ParseTypeOperand();
  return ParseConditional();
}

// Whether a template argument is a type. Of names that nobody declared, those with arguments of
// their own are.
bool Parser::AtTypeArgument() const {
  const std::size_t after = SkipTypeName(0);
  if (StartsType(0)) {
    if (after == 0 || Peek(after).kind == TokenKind::kLeftParen) return after == 0;
  } else {
    if (!AtName() && !At(TokenKind::kColonColon)) return false;
    if (after > 1 && IsTypeName(after - 1)) return true;  // ns::T
  }
  std::size_t name = At(TokenKind::kColonColon) ? 1 : 0;
  while (Peek(name + 1).kind == TokenKind::kColonColon && AtName(name + 2)) name += 2;
  if (Peek(name + 1).kind != TokenKind::kLess) return StartsType(0) && name == 0;
  const Meaning meaning = MeaningOf(Peek(name).name());
  if (meaning != Meaning::kType && meaning != Meaning::kUnknown) return false;
  if (WordAt() == Word::kTypename) return true;
  // S<T>::x is a value unless `typename` stands before it.
  const std::size_t close = SkipTemplateArguments(name + 1);
  return close == 0 || Peek(close).kind != TokenKind::kColonColon;
}

// T, or T[2]: what sizeof and template arguments take.
ExprId Parser::ParseTypeOperand() {
  const std::size_t start = pos_;
  ExprId type = AddExpr(start, TypeExpr{ParseType(false)});
  while (At(TokenKind::kLeftBracket) && !panic_) {
    const std::size_t open = pos_;
    Next();
    Bracketed bracketed(*this);
    const ExprId size = ParseConditional();
    ExpectClose(TokenKind::kRightBracket, open);
    type = AddExpr(start, IndexExpr{type, size});
  }
  return type;
}

// Qualifiers in any order, with attributes between them where the caller takes attributes.
Qualifiers Parser::ParseQualifiers(Collector<Attr>* attributes) {
  Qualifiers qualifiers = 0;
  while (!AtEnd()) {
    if (attributes && AtWord(Word::kLayout) && Peek(1).kind == TokenKind::kLeftParen) {
      ParseAttribute(*attributes, pos_);
    } else if (IsQualifier(0)) {
      qualifiers |= InfoOfName(Next().name()).qualifier;
    } else if (attributes && At(TokenKind::kLeftBracket) && !panic_) {
      ParseAttributes(*attributes);
    } else {
      break;
    }
  }
  return qualifiers;
}

// Any number of `[name]`, `[name(arguments)]`, `[a, b]` and `[[ns::name(arguments)]]`.
void Parser::ParseAttributes(Collector<Attr>& attributes) {
  while (At(TokenKind::kLeftBracket) && !panic_) ParseAttributeList(attributes);
}

void Parser::ParseAttributeList(Collector<Attr>& attributes) {
  const std::size_t start = pos_;
  Next();
  const bool doubled = Accept(TokenKind::kLeftBracket);
  while (!At(TokenKind::kRightBracket) && !AtEnd()) {
    if (!ParseAttribute(attributes, start)) break;
    if (!Accept(TokenKind::kComma)) break;
  }
  if (doubled) ExpectClose(TokenKind::kRightBracket, start + 1);
  ExpectClose(TokenKind::kRightBracket, start);
  if (panic_) SkipToClose(TokenKind::kRightBracket);
}

bool Parser::ParseAttribute(Collector<Attr>& attributes, std::size_t start) {
  const std::size_t name_at = pos_;
  if (!At(TokenKind::kIdentifier)) {
    Unexpected("the name of an attribute");
    return false;
  }
  Attr attribute;
  attribute.name = Next().name();
  while (At(TokenKind::kColonColon) && Peek(1).kind == TokenKind::kIdentifier) {
    Next();
    attribute.name = Intern(fmt::format("{}::{}", Text(attribute.name), Text(Next().name())));
  }
  attribute.name_span = SpanFrom(name_at);
  if (At(TokenKind::kLeftParen)) {
    attribute.has_parens = true;
    attribute.arguments = ParseArguments();
  }
  const bool doubled = tokens_[start + 1].kind == TokenKind::kLeftBracket;
  const std::size_t last = doubled && Peek(1).kind == TokenKind::kRightBracket ? 1 : 0;
  attribute.span = At(TokenKind::kRightBracket) ? Cover(tokens_[start].span(), Peek(last).span())
                                                : SpanFrom(start);
  attributes.Add(attribute);
  return !panic_;
}

// Any number of `[n]`, `[]`.
List<ExprId> Parser::ParseDimensions() {
  Bracketed bracketed(*this);
  Collector<ExprId> dimensions(expr_stack_);
  while (At(TokenKind::kLeftBracket) && !panic_) {
    const std::size_t open = pos_;
    Next();
    dimensions.Add(At(TokenKind::kRightBracket) ? ExprId{} : ParseConditional());
    if (!ExpectClose(TokenKind::kRightBracket, open)) SkipToClose(TokenKind::kRightBracket);
  }
  return dimensions.Finish(file_.expr_lists);
}

}  // namespace clipc::ast
