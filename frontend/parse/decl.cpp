// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <fmt/format.h>

#include "frontend/parse/parser.h"

// Declarations of every scope except functions (function.cpp) and structs (struct.cpp).
namespace clipc::ast {

File Parser::Run() {
  Collector decls(decls_);
  while (!AtEnd()) {
    if (AtOutsideStatement()) {
      ParseOutsideStatements();
    } else if (At(kRightBrace)) {
      Error(Here(), diag::StrayBrace);
      Next();
      EndPanic();
    } else {
      ParseOrSkipDeclaration(decls, Scope::kGlobal);
    }
  }
  file_.top_level.assign(decls.values().begin(), decls.values().end());
  file_.names = std::move(names_);
  if (file_.effect) file_.effect->tokens = std::move(tokens_);
  return std::move(file_);
}

// Whether the current token can only begin a statement, though no function is open.
bool Parser::AtOutsideStatement() const {
  if (IsStatementWord(WordAt())) return true;
  if (!AtName()) return false;
  switch (Peek(1).kind) {
    case kDot:
    case kPlusPlus:
    case kMinusMinus: return true;
    case kLeftBracket: return !At(kLeftBracket, 2);
    default: return IsAssignment(Peek(1).kind);
  }
}

// Parses statements outside of a function, most likely because the function ended at a `}` too
// many: reports them once, then reads the rest of the body and the `}` that may end it.
void Parser::ParseOutsideStatements() {
  if (!outside_reported_) Error(Here(), diag::StatementOutsideFunction, Describe());
  outside_reported_ = true;
  EndPanic();
  while (AtOutsideStatement()) {
    const std::size_t before = pos_;
    if (!AtWord(Word::kElse)) ParseStatement();
    if (pos_ == before) Next();  // a statement that is left for a function takes nothing
  }
  leaving_function_ = false;
  Accept(kRightBrace);
}

// Reads declarations up to the `}` that closes the `{` at `open`.
void Parser::ParseMembers(Decls& decls, Scope scope, std::size_t open) {
  while (!At(kRightBrace) && !AtEnd()) ParseOrSkipDeclaration(decls, scope);
  ExpectClose(kRightBrace, open);
}

// Parses a declaration, or skips it after an error so that the next declaration can be read. Takes
// at least one token.
void Parser::ParseOrSkipDeclaration(Decls& decls, Scope scope) {
  const std::size_t before = pos_;
  ParseDeclaration(decls, scope);
  if (panic_) SkipDeclaration(scope != Scope::kGlobal);
  if (pos_ == before) Next();
}

void Parser::ParseDeclaration(Decls& decls, Scope scope) {
  if (Accept(kSemicolon)) return;
  Nesting nesting(*this, 2);
  if (nesting.ok() && !ParseKeywordDeclaration(decls, scope)) ParseSpecified(decls, scope, {});
}

// Reads a declaration that starts with a word of its own; returns false if there is none.
bool Parser::ParseKeywordDeclaration(Decls& decls, Scope scope) {
  switch (WordAt()) {
    case Word::kTypedef: ParseTypedef(decls); return true;
    case Word::kUsing: ParseUsing(decls, {}); return true;
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
  if (scope != Scope::kStruct || !AtName() || !At(kColon, 1)) return false;
  const std::string_view text = TextAt();
  if (text != "public" && text != "private" && text != "protected") return false;
  Skip(2);
  return true;
}

// Parses attributes, qualifiers and type. There is no type before a word that starts a declaration
// without one.
Parser::Specifiers Parser::ParseSpecifiers(std::string_view expected) {
  Specifiers specifiers;
  specifiers.start = pos_;
  Collector attributes(attrs_);
  specifiers.qualifiers = ParseQualifiers(&attributes) | PackingHere();
  if (!panic_ && !AtAnyOf(kOutsideWords | Words(Word::kTypedef, Word::kUsing))) {
    if (AtName() || StartsType(0) || At(kColonColon)) {
      specifiers.type = ParseType(true);
      if (At(kLeftBracket) && At(kLeftBracket, 1)) ParseAttributes(attributes);
      // `float4 const x`
      while (AtWord(Word::kQualifier) && !(InfoOf(Peek().name()).qualifier & (kIn | kOut))) {
        specifiers.qualifiers |= InfoOf(Next().name()).qualifier;
      }
    } else {
      Unexpected(expected);
    }
  }
  specifiers.attributes = attributes.Finish();
  return specifiers;
}

// Parses specifiers of which one must be a type; returns false after an error, which is reported.
bool Parser::ParseTypedSpecifiers(Specifiers& specifiers, std::string_view expected) {
  specifiers = ParseSpecifiers(expected);
  if (!specifiers.type) Unexpected(expected);
  return !panic_;
}

void Parser::ParseSpecified(Decls& decls, Scope scope, const TemplateHeader& header) {
  const Specifiers specifiers = ParseSpecifiers("a declaration");
  if (panic_) return;
  if (!specifiers.type) {  // [[attribute]] typedef ...; [[attribute]] cbuffer ...
    const bool is_buffer = kBufferWords.Has(WordAt());
    CheckAttributes(specifiers.attributes,
                    is_buffer ? AttributeOwner::kBuffer : AttributeOwner::kOther,
                    fmt::format("a `{}`", TextAt()));
    if (!ParseKeywordDeclaration(decls, scope)) ParseBuffer(decls, specifiers);
  } else if (ParseTypeOnly(decls, specifiers)) {
    return;
  } else if (AtFunctionDeclarator()) {
    ParseFunction(decls, scope, specifiers, header);
  } else {
    ParseVariables(decls, scope, specifiers);
  }
}

// Parses the rest of `struct S {...};`, a definition without declarators; returns false if there
// are declarators.
bool Parser::ParseTypeOnly(Decls& decls, const Specifiers& specifiers) {
  const DeclId definition = file_.types[specifiers.type].struct_definition;
  if (!definition || (!At(kSemicolon) && !StructEndsHere())) return false;
  ParseEndOfType(definition);
  CheckAttributes(specifiers.attributes, AttributeOwner::kOther, "the definition of a type");
  auto* structure = std::get_if<StructDecl>(&file_.decls[definition].node);
  if (structure && structure->attributes.empty()) structure->attributes = specifiers.attributes;
  decls.Add(definition);
  return true;
}

// Parses one or more declarators, up to the `;`.
void Parser::ParseVariables(Decls& decls, Scope scope, const Specifiers& specifiers) {
  std::size_t start = specifiers.start;
  const TokenRange type{start, pos_};
  const bool is_kept = file_.effect && (scope == Scope::kGlobal || scope == Scope::kBuffer);
  VarDecl var{};
  do {
    var = MakeVar(specifiers);
    if (AtDeclaratorScope()) ParseDeclaratorScope(var.out_of_line_of);
    const bool is_field = scope == Scope::kStruct;
    const bool is_unnamed = is_field && At(kColon);  // a bit-field
    if (!is_unnamed &&
        !ParseDeclaratorName(var.name, var.name_span, is_field ? "field" : "variable"))
      return;
    if (start == specifiers.start)  // once for all declarators
      CheckQualifiers(specifiers.qualifiers,
                      is_field                 ? QualifierOwner::kField
                      : scope == Scope::kLocal ? QualifierOwner::kLocal
                                               : QualifierOwner::kGlobal,
                      var.name_span);
    if (!var.out_of_line_of.name) Declare(var.name, Meaning::kValue);
    ParseDeclaratorTail(var, scope);
    if (is_kept) {
      variable_.name = var.name;
      variable_.semantic = var.semantic.name;
      variable_.type = type;
      file_.effect->variables.push_back(variable_);
    }
    decls.Add(AddDecl(start, var));
    start = pos_ + 1;
  } while (!panic_ && Accept(kComma));
  if (At(kSemicolon)) {  // almost always: no words for a message are made
    ExpectSemicolon({});
  } else if (!var.has_state_block || tokens_[pos_ - 1].kind != kRightBrace) {
    // `Texture2D t <annotation> {...}` may do without a `;`.
    ExpectSemicolon(fmt::format("the declaration of `{}`", Text(var.name)));
  }
  // A function that is cut off looks like a variable.
  if (!panic_) {
    const bool is_field = scope == Scope::kStruct;
    CheckAttributes(specifiers.attributes,
                    is_field                  ? AttributeOwner::kField
                    : scope == Scope::kGlobal ? AttributeOwner::kVariable
                                              : AttributeOwner::kOther,
                    is_field ? "a field" : "a variable");
  }
}

// cbuffer Name : register(b0) {...}
void Parser::ParseBuffer(Decls& decls, const Specifiers& specifiers) {
  BufferDecl buffer{};
  buffer.kind = AtWord(Word::kCbuffer) ? BufferKind::kCbuffer : BufferKind::kTbuffer;
  buffer.attributes = specifiers.attributes;
  Next();
  if (At(kIdentifier) && !ParseDeclaratorName(buffer.name, buffer.name_span, "constant buffer"))
    return;
  VarDecl parts{};
  ParseColonParts(parts);
  buffer.registers = parts.registers;
  const std::size_t open = pos_;
  if (!Expect(kLeftBrace, "`{` and the members of the constant buffer")) return;
  Collector members(decls_);
  ParseMembers(members, Scope::kBuffer, open);
  buffer.members = members.Finish();
  decls.Add(AddDecl(specifiers.start, buffer));
}

// namespace A::B {...}. For B the `::` takes the place of `namespace`.
void Parser::ParseNamespace(Decls& decls) {
  const std::size_t start = pos_;
  Next();
  Nesting nesting(*this, 1);
  if (!nesting.ok()) return;
  NamespaceDecl space{};
  if (AtName()) TakeName(space, Meaning::kNamespace);
  NameScope scope(*this);
  Collector members(decls_);
  if (At(kColonColon) && space.name) {
    ParseNamespace(members);
  } else {
    const std::size_t open = pos_;
    if (!Expect(kLeftBrace, "`{` and the members of the namespace")) return;
    ParseMembers(members, Scope::kGlobal, open);
  }
  space.members = members.Finish();
  decls.Add(AddDecl(start, space));
}

// typedef float4 A, B[2];
void Parser::ParseTypedef(Decls& decls) {
  const std::size_t typedef_at = pos_;
  std::size_t start = typedef_at;
  Next();
  Specifiers specifiers;
  if (!ParseTypedSpecifiers(specifiers, "a type")) return;
  do {
    TypedefDecl decl{};
    decl.type = specifiers.type;
    decl.qualifiers = specifiers.qualifiers;
    if (!ParseDeclaratorName(decl.name, decl.name_span, "type")) return;
    if (start == typedef_at)
      CheckQualifiers(specifiers.qualifiers, QualifierOwner::kTypedef, decl.name_span);
    Declare(decl.name, Meaning::kType);
    decl.dimensions = ParseDimensions();
    decls.Add(AddDecl(start, decl));
    start = pos_ + 1;
  } while (!panic_ && Accept(kComma));
  ExpectSemicolon("the typedef");
}

// using namespace a::b;  using a::b;  using T = float4;
void Parser::ParseUsing(Decls& decls, const TemplateHeader& header) {
  const std::size_t start = pos_;
  Next();
  if (AtName() && (At(kEqual, 1) || At(kLeftBracket, 1))) {
    TypedefDecl decl{};
    decl.template_parameters = header.parameters;
    decl.is_template = header.present;
    decl.name_span = Here();
    decl.name = Next().name();
    CheckAttributes(ParseAttributes(), AttributeOwner::kOther, "the definition of a type");
    Expect(kEqual, "`=`");
    Specifiers specifiers;
    if (!ParseTypedSpecifiers(specifiers, "a type")) return;
    decl.type = specifiers.type;
    decl.qualifiers = specifiers.qualifiers;
    CheckQualifiers(specifiers.qualifiers, QualifierOwner::kTypedef, decl.name_span);
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

// Parses static_assert(...), which is about types that the entry point does not choose, and so is
// not kept.
void Parser::ParseStaticAssert() {
  Next();
  if (!At(kLeftParen)) return Unexpected("`(`");
  SkipBalanced();
  ExpectSemicolon("the assertion");
}

// Reports a declaration of GLSL whose first word would be a type, `attribute vec3 place;` or
// `precision mediump float;`, before its third word. Returns whether it is one.
bool Parser::ReportGlslWord() {
  if (pos_ < 2 || tokens_[pos_ - 2].kind != kIdentifier) return false;
  const std::string_view word = Text(tokens_[pos_ - 2].name());
  const bool is_attribute = word == "attribute";
  if (!is_attribute && word != "precision" && word != "highp" && word != "mediump" &&
      word != "lowp")
    return false;
  Error(tokens_[pos_ - 2].span(), diag::GlslWord, word,
        is_attribute ? "an input is a parameter of the entry function, with a semantic"
                     : "remove it, or declare `min16float`");
  panic_ = true;
  return true;
}

// Takes a `;`. A missing one is reported after the token before, where it is missing; the text
// after that is read as if it were there.
void Parser::ExpectSemicolon(std::string_view after) {
  if (Accept(kSemicolon)) return EndPanic();
  if (panic_) return;
  if (!At(kIdentifier) && !At(kRightBrace) && !AtEnd() && !At(kLeftBracket)) {
    Unexpected(fmt::format("`;` after {}", after));
    if (At(kLeftBrace)) SkipBalanced();  // S s = S{1, 2};
    return;
  }
  if (ReportGlslWord()) return;
  Diagnostic* report = Error(PreviousSpan(), diag::MissingSemicolon, after);
  const std::string text = PreviousText();
  if (report && !text.empty()) report->Fix(PreviousSpan(), text + ";");
  // A new statement starts here, rather than a word too many in an expression: `a = b c;`.
  const bool starts_anew = !At(kIdentifier) || IsReserved(WordAt()) || IsDeclaration() ||
                           At(kEqual, 1) || At(kLeftParen, 1) || At(kDot, 1);
  if (starts_anew) panic_ = aborted_ || AtEnd();
}

}  // namespace clipc::ast
