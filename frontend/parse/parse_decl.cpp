// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/parser.h"

// Declarations of every scope except functions (parse_function.cpp) and structs (parse_struct.cpp).
namespace clipc::ast {

void Parser::ParseTopLevel() {
  Decls decls(decl_stack_);
  while (!AtEnd()) {
    const std::size_t before = pos_;
    if (AtOutsideStatement()) {
      ParseOutsideStatements();
      continue;
    }
    if (At(TokenKind::kRightBrace)) {
      Error(Here(), diag::StrayBrace);
      Next();
      panic_ = aborted_;
      continue;
    }
    ParseDeclaration(decls, Scope::kGlobal);
    if (panic_) SyncDeclaration(Scope::kGlobal);
    if (pos_ == before) Next();
  }
  file_.top_level.assign(decl_stack_.begin(), decl_stack_.end());
}

// What can only be a statement, though no function is open.
bool Parser::AtOutsideStatement() const {
  if (IsStatementWord(WordAt())) return true;
  if (!AtName()) return false;
  switch (Peek(1).kind) {
    case TokenKind::kDot:
    case TokenKind::kPlusPlus:
    case TokenKind::kMinusMinus: return true;
    case TokenKind::kLeftBracket: return Peek(2).kind != TokenKind::kLeftBracket;
    default: return IsAssignment(Peek(1).kind);
  }
}

// A `}` too many, most likely: one error, then the rest of the body, with a `}` that may end it.
void Parser::ParseOutsideStatements() {
  if (!outside_reported_) Error(Here(), diag::StatementOutsideFunction, Describe());
  outside_reported_ = true;
  panic_ = aborted_;
  while (AtOutsideStatement()) {
    if (AtWord(Word::kElse))
      Next();
    else
      ParseStatement();
  }
  Accept(TokenKind::kRightBrace);
}

// Up to the `}` that closes the `{` at `open`.
void Parser::ParseMembers(Decls& decls, Scope scope, std::size_t open) {
  while (!At(TokenKind::kRightBrace) && !AtEnd()) {
    const std::size_t before = pos_;
    ParseDeclaration(decls, scope);
    if (panic_) SyncDeclaration(scope);
    if (pos_ == before) Next();
  }
  ExpectClose(TokenKind::kRightBrace, open);
}

void Parser::ParseDeclaration(Decls& decls, Scope scope) {
  if (Accept(TokenKind::kSemicolon)) return;
  Nesting nesting(*this, 2);
  if (!nesting.ok()) return;
  if (!ParseKeywordDeclaration(decls, scope)) ParseSpecified(decls, scope, {});
}

// False: none of these.
bool Parser::ParseKeywordDeclaration(Decls& decls, Scope scope) {
  switch (WordAt()) {
    case Word::kTypedef: ParseTypedef(decls); return true;
    case Word::kUsing: ParseUsing(decls); return true;
    case Word::kNamespace: ParseNamespace(decls); return true;
    case Word::kTemplate: ParseTemplate(decls, scope); return true;
    case Word::kStaticAssert: ParseStaticAssert(); return true;
    case Word::kTechnique:
      if (scope != Scope::kGlobal || !AtDeclarationWord()) return false;
      ParseTechnique();
      return true;
    default: break;
  }
  // `public:`
  if (scope == Scope::kStruct && AtName() && Peek(1).kind == TokenKind::kColon) {
    const std::string_view text = Text(Peek().name());
    if (text != "public" && text != "private" && text != "protected") return false;
    Next();
    Next();
    return true;
  }
  return false;
}

// Attributes, qualifiers and type; no type before a keyword that starts a declaration without one.
Parser::Specifiers Parser::ParseSpecifiers(std::string_view expected) {
  Specifiers specifiers;
  specifiers.start = pos_;
  Collector<Attr> attributes(attr_stack_);
  specifiers.qualifiers = ParseQualifiers(&attributes) | PackingHere();
  const Word word = WordAt();
  const bool keyword = word == Word::kCbuffer || word == Word::kTbuffer || word == Word::kTypedef ||
                       word == Word::kUsing || word == Word::kNamespace || word == Word::kTemplate;
  if (!panic_ && !keyword) {
    if (AtName() || StartsType(0) || At(TokenKind::kColonColon)) {
      specifiers.type = ParseType(true);
      if (At(TokenKind::kLeftBracket) && Peek(1).kind == TokenKind::kLeftBracket)
        ParseAttributes(attributes);
      // `float4 const x`
      while (AtWord(Word::kQualifier) && !(InfoOfName(Peek().name()).qualifier & (kIn | kOut))) {
        specifiers.qualifiers |= InfoOfName(Next().name()).qualifier;
      }
    } else {
      Unexpected(expected);
    }
  }
  specifiers.attributes = attributes.Finish(file_.attrs);
  return specifiers;
}

void Parser::ParseSpecified(Decls& decls, Scope scope, const TemplateHeader& header) {
  const Specifiers specifiers = ParseSpecifiers("a declaration");
  if (panic_) return;
  if (!specifiers.type && ParseKeywordDeclaration(decls, scope)) return;  // [[attribute]] typedef
  if (!specifiers.type) {
    ParseBuffer(decls, specifiers);
  } else if (ParseTypeOnly(decls, specifiers)) {
    return;
  } else if (AtFunctionDeclarator()) {
    ParseFunction(decls, scope, specifiers, header);
  } else {
    ParseVariables(decls, scope, specifiers);
  }
}

// `struct S {...};`: a definition without declarators.
bool Parser::ParseTypeOnly(Decls& decls, const Specifiers& specifiers) {
  const DeclId definition = file_.types[specifiers.type].struct_definition;
  if (!definition || (!At(TokenKind::kSemicolon) && !StructEndsHere())) return false;
  ParseEndOfType(definition);
  auto* structure = std::get_if<StructDecl>(&file_.decls[definition].node);
  if (structure && structure->attributes.empty()) structure->attributes = specifiers.attributes;
  decls.Add(definition);
  return true;
}

// One or more declarators, up to the `;`.
void Parser::ParseVariables(Decls& decls, Scope scope, const Specifiers& specifiers) {
  std::size_t start = specifiers.start;
  Name name;
  do {
    VarDecl var{};
    var.type = specifiers.type;
    var.qualifiers = specifiers.qualifiers;
    var.attributes = specifiers.attributes;
    if (AtDeclaratorScope()) ParseDeclaratorScope(var.out_of_line_of);
    const std::string_view what = scope == Scope::kStruct ? "field" : "variable";
    const bool unnamed_bits = scope == Scope::kStruct && At(TokenKind::kColon);
    if (!unnamed_bits && !ParseDeclaratorName(var.name, var.name_span, what)) return;
    name = var.name;
    if (!var.out_of_line_of.name) Declare(name, Meaning::kValue);
    ParseDeclaratorTail(var, scope);
    decls.Add(AddDecl(start, var));
    start = pos_ + 1;
  } while (!panic_ && Accept(TokenKind::kComma));
  // `Texture2D t <annotation> {...}` may do without.
  const bool ends_in_block = std::get<VarDecl>(file_.decls[decls.last()].node).has_state_block &&
                             tokens_[pos_ - 1].kind == TokenKind::kRightBrace;
  if (ends_in_block && !At(TokenKind::kSemicolon)) return;
  // Most statements end here: the words for a message are made only when there is one.
  ExpectSemicolon(At(TokenKind::kSemicolon) ? std::string()
                                            : fmt::format("the declaration of `{}`", Text(name)));
}

// cbuffer Name : register(b0) {...}, with the specifiers before it.
void Parser::ParseBuffer(Decls& decls, const Specifiers& specifiers) {
  BufferDecl buffer{};
  buffer.kind = AtWord(Word::kCbuffer) ? BufferKind::kCbuffer : BufferKind::kTbuffer;
  buffer.attributes = specifiers.attributes;
  Next();
  if (At(TokenKind::kIdentifier) &&
      !ParseDeclaratorName(buffer.name, buffer.name_span, "constant buffer"))
    return;
  Collector<RegisterBinding> registers(register_stack_);
  VarDecl ignored{};
  while ((At(TokenKind::kColon) || At(TokenKind::kLess)) && !panic_) {
    if (At(TokenKind::kLess))
      SkipAnnotation();
    else
      ParseColonPart(ignored, registers);
  }
  buffer.registers = registers.Finish(file_.registers);
  const std::size_t open = pos_;
  if (!Expect(TokenKind::kLeftBrace, "`{` and the members of the constant buffer")) return;
  Decls members(decl_stack_);
  ParseMembers(members, Scope::kBuffer, open);
  buffer.members = members.Finish(file_.decl_lists);
  decls.Add(AddDecl(specifiers.start, buffer));
}

// namespace A::B {...}
void Parser::ParseNamespace(Decls& decls) {
  const std::size_t start = pos_;
  Next();  // `namespace`, or the `::` of an outer one
  Nesting nesting(*this, 1);
  if (!nesting.ok()) return;
  NamespaceDecl space{};
  if (AtName()) {
    space.name_span = Here();
    space.name = Next().name();
    Declare(space.name, Meaning::kNamespace);
  }
  NameScope scope(*this);
  Decls members(decl_stack_);
  if (At(TokenKind::kColonColon) && space.name) {
    ParseNamespace(members);
  } else {
    const std::size_t open = pos_;
    if (!Expect(TokenKind::kLeftBrace, "`{` and the members of the namespace")) return;
    ParseMembers(members, Scope::kGlobal, open);
  }
  space.members = members.Finish(file_.decl_lists);
  decls.Add(AddDecl(start, space));
}

void Parser::ParseTypedef(Decls& decls) {
  std::size_t start = pos_;
  Next();
  const Specifiers specifiers = ParseSpecifiers("a type");
  if (panic_) return;
  if (!specifiers.type) {
    Unexpected("a type");
    return;
  }
  do {
    TypedefDecl decl{};
    decl.type = specifiers.type;
    decl.qualifiers = specifiers.qualifiers;
    if (!ParseDeclaratorName(decl.name, decl.name_span, "type")) return;
    Declare(decl.name, Meaning::kType);
    decl.dimensions = ParseDimensions();
    decls.Add(AddDecl(start, decl));
    start = pos_ + 1;
  } while (!panic_ && Accept(TokenKind::kComma));
  ExpectSemicolon("the typedef");
}

// using namespace a::b;  using a::b;  using T = float4;
void Parser::ParseUsing(Decls& decls) {
  const std::size_t start = pos_;
  Next();
  const TokenKind behind = Peek(1).kind;
  if (AtName() && (behind == TokenKind::kEqual || behind == TokenKind::kLeftBracket)) {
    TypedefDecl decl{};
    decl.name_span = Here();
    decl.name = Next().name();
    Collector<Attr> ignored(attr_stack_);
    ParseAttributes(ignored);
    Expect(TokenKind::kEqual, "`=`");
    const Specifiers specifiers = ParseSpecifiers("a type");
    if (panic_ || !specifiers.type) return;
    decl.type = specifiers.type;
    decl.qualifiers = specifiers.qualifiers;
    decl.dimensions = ParseDimensions();
    Declare(decl.name, Meaning::kType);
    decls.Add(AddDecl(start, decl));
  } else {
    UsingDecl decl{};
    decl.is_namespace = AtWord(Word::kNamespace);
    if (decl.is_namespace) Next();
    decl.name = ParseQualifiedName();
    decls.Add(AddDecl(start, decl));
  }
  ExpectSemicolon("`using`");
}

// Only about types that a vertex shader does not choose: nothing of it is kept.
void Parser::ParseStaticAssert() {
  Next();
  if (!At(TokenKind::kLeftParen)) {
    Unexpected("`(`");
    return;
  }
  SkipBalanced();
  ExpectSemicolon("the assertion");
}

}  // namespace clipc::ast
