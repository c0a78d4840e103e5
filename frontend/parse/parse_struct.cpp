// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/parser.h"

namespace clipc::ast {

// struct, class or interface, with or without a body, at its keyword. What follows the `}` is the
// caller's.
DeclId Parser::ParseStruct(const TemplateHeader& header) {
  const std::size_t start = pos_;
  StructDecl decl{};
  decl.is_template = header.present;
  decl.template_parameters = header.parameters;
  switch (WordAt()) {
    case Word::kClass: decl.kind = StructKind::kClass; break;
    case Word::kInterface: decl.kind = StructKind::kInterface; break;
    default: decl.kind = StructKind::kStruct; break;
  }
  Next();
  Collector<Attr> attributes(attr_stack_);
  ParseAttributes(attributes);
  decl.attributes = attributes.Finish(file_.attrs);
  if (AtName()) {
    decl.name_span = Here();
    decl.name = Next().name();
    Declare(decl.name, Meaning::kType);
    if (header.present && At(TokenKind::kLess)) decl.template_arguments = ParseTemplateArguments();
  }
  if (At(TokenKind::kColon)) decl.bases = ParseBases();
  Nesting nesting(*this, 3);
  if (!nesting.ok()) return AddDecl(start, decl);
  const std::size_t open = pos_;
  if (!At(TokenKind::kLeftBrace)) {
    decl.is_definition = false;
    if (!At(TokenKind::kSemicolon) || !decl.name)
      Unexpected(decl.name ? "`{` or `;`" : "`{` or a name");
    return AddDecl(start, decl);
  }
  Next();
  NameScope scope(*this);
  Decls members(decl_stack_);
  ParseMembers(members, Scope::kStruct, open);
  decl.members = members.Finish(file_.decl_lists);
  return AddDecl(start, decl);
}

List<TypeId> Parser::ParseBases() {
  Collector<TypeId> bases(type_stack_);
  Next();
  do {
    if (AtName(0) && AtName(1) && Text(Peek().name()) == "public") Next();
    bases.Add(ParseNamedType());
  } while (!panic_ && Accept(TokenKind::kComma));
  return bases.Finish(file_.type_lists);
}

std::string Parser::DescribeType(DeclId definition) const {
  const auto* is_enum = std::get_if<EnumDecl>(&file_.decls[definition].node);
  const Name name =
      is_enum ? is_enum->name : std::get<StructDecl>(file_.decls[definition].node).name;
  const std::string_view kind = is_enum ? "enum" : "struct";
  return name ? fmt::format("{} `{}`", kind, Text(name)) : fmt::format("a {}", kind);
}

// The `;` behind a definition. Real shaders forget it, and some compilers let them.
void Parser::ParseEndOfType(DeclId definition) {
  if (Accept(TokenKind::kSemicolon) || panic_) return;
  diagnostics_.Report(PreviousSpan(), diag::MissingSemicolonAfterType, DescribeType(definition))
      .Fix(PreviousSpan(), "};");
}

// enum class E : uint {A, B = 2}
DeclId Parser::ParseEnum() {
  const std::size_t start = pos_;
  EnumDecl decl{};
  Next();
  if (AtWord(Word::kClass) || AtWord(Word::kStruct)) {
    decl.is_class = true;
    Next();
  }
  if (AtName()) {
    decl.name_span = Here();
    decl.name = Next().name();
    Declare(decl.name, Meaning::kType);
  }
  if (Accept(TokenKind::kColon)) decl.underlying = ParseNamedType();
  decl.enumerators = ParseEnumerators();
  return AddDecl(start, decl);
}

List<Enumerator> Parser::ParseEnumerators() {
  const std::size_t open = pos_;
  if (!Expect(TokenKind::kLeftBrace, "`{` and the values of the enum")) return {};
  Collector<Enumerator> enumerators(enumerator_stack_);
  while (!At(TokenKind::kRightBrace) && !AtEnd()) {
    Enumerator enumerator;
    if (!ParseDeclaratorName(enumerator.name, enumerator.span, "value of an enum")) break;
    Declare(enumerator.name, Meaning::kValue);
    if (Accept(TokenKind::kEqual)) enumerator.value = ParseConditional();
    enumerators.Add(enumerator);
    if (panic_ || !Accept(TokenKind::kComma)) break;
  }
  if (!ExpectClose(TokenKind::kRightBrace, open)) SkipToClose(TokenKind::kRightBrace);
  return enumerators.Finish(file_.enumerators);
}

}  // namespace clipc::ast
