// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <fmt/format.h>

#include "frontend/parse/parser.h"

namespace clipc::ast {

// Parses struct S {...}, class S : B {...} or interface I; the caller reads the text after it.
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
  decl.attributes = ParseAttributes();
  CheckAttributes(decl.attributes, AttributeOwner::kOther, "the definition of a type");
  if (AtName()) {
    TakeName(decl, Meaning::kType);
    if (header.present && At(kLess)) decl.template_arguments = ParseTemplateArguments();
  }
  if (At(kColon)) decl.bases = ParseBases();
  Nesting nesting(*this, 3);
  if (!nesting.ok()) return AddDecl(start, decl);
  const std::size_t open = pos_;
  if (!At(kLeftBrace)) {
    decl.is_definition = false;
    if (!At(kSemicolon) || !decl.name) Unexpected(decl.name ? "`{` or `;`" : "`{` or a name");
    return AddDecl(start, decl);
  }
  Next();
  NameScope scope(*this);
  Collector members(decls_);
  ParseMembers(members, Scope::kStruct, open);
  decl.members = members.Finish();
  return AddDecl(start, decl);
}

List<TypeId> Parser::ParseBases() {
  Collector bases(types_);
  Next();
  do {
    if (AtName(1) && TextAt() == "public") Next();
    bases.Add(ParseNamedType());
  } while (!panic_ && Accept(kComma));
  return bases.Finish();
}

Name Parser::NameOfType(DeclId definition) const {
  const auto& node = file_.decls[definition].node;
  const auto* is_enum = std::get_if<EnumDecl>(&node);
  return is_enum ? is_enum->name : std::get<StructDecl>(node).name;
}

// Parses the `;` after a definition. Real shaders forget it, and some compilers accept that.
void Parser::ParseEndOfType(DeclId definition) {
  if (Accept(kSemicolon) || panic_) return;
  const Name name = NameOfType(definition);
  const bool is_enum = std::holds_alternative<EnumDecl>(file_.decls[definition].node);
  const std::string_view kind = is_enum ? "enum" : "struct";
  diagnostics_
      .Report(PreviousSpan(), diag::MissingSemicolonAfterType,
              name ? fmt::format("{} `{}`", kind, Text(name)) : fmt::format("a {}", kind))
      .Fix(PreviousSpan(), "};");
}

// enum class E : uint {A, B = 2}
DeclId Parser::ParseEnum() {
  const std::size_t start = pos_;
  EnumDecl decl{};
  Next();
  decl.is_class = AtAnyOf({Word::kClass, Word::kStruct});
  if (decl.is_class) Next();
  file_.has_enums = true;
  if (AtName()) TakeName(decl, Meaning::kType);
  if (Accept(kColon)) decl.underlying = ParseNamedType();
  decl.enumerators = ParseEnumerators();
  return AddDecl(start, decl);
}

List<Enumerator> Parser::ParseEnumerators() {
  const std::size_t open = pos_;
  if (!Expect(kLeftBrace, "`{` and the values of the enum")) return {};
  Collector enumerators(enumerators_);
  ParseList(kRightBrace, open, {}, [&] {
    Enumerator enumerator;
    if (!ParseDeclaratorName(enumerator.name, enumerator.span, "value of an enum")) return;
    Declare(enumerator.name, Meaning::kValue);
    if (Accept(kEqual)) enumerator.value = ParseConditional();
    enumerators.Add(enumerator);
  });
  return enumerators.Finish();
}

}  // namespace clipc::ast
