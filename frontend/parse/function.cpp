// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <fmt/format.h>

#include "frontend/parse/parser.h"

// Functions, their parameters and templates.
namespace clipc::ast {

// template<typename T, uint N = 2> before a struct, a function or a variable
void Parser::ParseTemplate(Decls& decls, Scope scope) {
  Next();
  const std::size_t open = pos_;
  if (!Expect(kLess, "`<`")) return;
  NameScope names(*this);
  Nesting nesting(*this, 0);
  if (!nesting.ok()) return;
  TemplateHeader header;
  header.present = true;
  Collector parameters(template_parameters_);
  while (!At(kGreater) && !AtEnd()) {
    parameters.Add(ParseTemplateParameter());
    if (panic_ || !Accept(kComma)) break;
  }
  if (!ExpectClose(kGreater, open)) return;
  header.parameters = parameters.Finish();
  if (AtAnyOf({Word::kStruct, Word::kClass}) && AtName(1) && !At(kIdentifier, 2)) {
    const DeclId definition = ParseStruct(header);
    decls.Add(definition);
    ParseEndOfType(definition);
  } else if (AtWord(Word::kUsing)) {
    ParseUsing(decls, header);
  } else {
    ParseSpecified(decls, scope, header);
  }
}

TemplateParameter Parser::ParseTemplateParameter() {
  const std::size_t start = pos_;
  TemplateParameter parameter{};
  parameter.is_type = AtAnyOf({Word::kTypename, Word::kClass});
  if (parameter.is_type) {
    Next();
  } else {
    parameter.type = ParseSpecifiers("a template parameter").type;
  }
  if (AtName()) parameter.name = Next().name();
  Declare(parameter.name, parameter.is_type ? Meaning::kType : Meaning::kValue);
  if (Accept(kEqual)) parameter.default_value = ParseTemplateArgument();
  parameter.span = SpanFrom(start);
  return parameter;
}

// Whether the text goes on with `S::` or `S<T>::`, before the name that is declared.
bool Parser::AtDeclaratorScope() const {
  if (!AtName() || WordAt() == Word::kOperator) return false;
  if (At(kColonColon, 1)) return true;
  if (!At(kLess, 1)) return false;
  const std::size_t after = SkipTemplateArguments(1);
  return after != 0 && At(kColonColon, after);
}

// Parses `S::` or `S<T>::`. Returns the template arguments.
List<ExprId> Parser::ParseDeclaratorScope(QualifiedName& scope) {
  Collector scopes(name_lists_);
  List<ExprId> arguments;
  while (AtDeclaratorScope() && !panic_) {
    scopes.Add(Next().name());
    if (At(kLess)) arguments = ParseTemplateArguments();
    Accept(kColonColon);
  }
  scope.name = scopes.last();
  scopes.RemoveLast();
  scope.scopes = scopes.Finish();
  return arguments;
}

// Whether the text goes on with `name(`, `S::name(`, `name<float>(` or an operator.
bool Parser::AtFunctionDeclarator() const {
  std::size_t i = 0;
  while (At(kIdentifier, i)) {
    if (WordAt(i) == Word::kOperator) return true;
    ++i;
    if (At(kLess, i)) {
      const std::size_t after = SkipTemplateArguments(i);
      if (after != 0) i = after;
    }
    if (At(kLeftParen, i)) return true;
    if (!At(kColonColon, i)) return false;
    ++i;
  }
  return false;
}

// Parses the rest of a function, from its name on.
void Parser::ParseFunction(Decls& decls, Scope scope, const Specifiers& specifiers,
                           const TemplateHeader& header) {
  FunctionDecl function{};
  function.return_type = specifiers.type;
  function.qualifiers = specifiers.qualifiers;
  function.attributes = specifiers.attributes;
  CheckAttributes(function.attributes, AttributeOwner::kFunction, "a function");
  function.template_parameters = header.parameters;
  function.is_template = header.present;
  if (scope == Scope::kLocal && !ParseLocalFunction(specifiers)) return;
  ParseFunctionName(function);
  if (panic_) return;
  CheckQualifiers(function.qualifiers,
                  scope == Scope::kStruct || function.out_of_line_of.name
                      ? QualifierOwner::kMethod
                      : QualifierOwner::kFunction,
                  function.name_span);
  if (!function.out_of_line_of.name) {
    Declare(function.name, header.present ? Meaning::kFunctionTemplate : Meaning::kFunction);
  }
  NameScope names(*this);
  function.parameters = ParseParameters();
  function.return_dimensions = ParseDimensions();
  function.is_const_method = TextAt() == "const";
  if (function.is_const_method) Next();
  VarDecl parts{};
  ParseColonParts(parts);
  function.return_semantic = parts.semantic;
  if (panic_ && At(kLeftBrace)) EndPanic();
  if (At(kLeftBrace) && !panic_) {
    function.body = ParseFunctionBody();
  } else if (!panic_ && !At(kSemicolon)) {
    Unexpected(fmt::format("`{{` or `;` after the header of `{}`", Text(function.name)));
    // The `{` was forgotten: the body is read as if it were there.
    if (IsStatementWord(WordAt())) {
      EndPanic();
      function.body = ParseFunctionBody();
    }
  } else {
    Accept(kSemicolon);
  }
  decls.Add(AddDecl(specifiers.start, function));
}

// Looks at a function that is declared inside a function. Returns true for a prototype, which is
// still to be read. A definition means that a `}` is missing before it; the text is read on as if
// it were there.
bool Parser::ParseLocalFunction(const Specifiers& specifiers) {
  std::size_t name_at = 0;
  while (At(kColonColon, name_at + 1)) name_at += 2;
  const std::size_t first = name_at + 2;
  const bool has_parameters = At(kRightParen, first) || SkipQualifiers(first) > first ||
                              (StartsType(first) && !At(kLeftParen, first + 1)) ||
                              (AtName(first) && AtName(first + 1));
  if (!has_parameters) {  // float3 x(1, 2, 3);
    Skip(name_at + 1);
    Unexpected("`;` or `=` after the name of a variable");
    return false;
  }
  const std::size_t after = SkipBrackets(name_at + 1);
  if (after != 0 && At(kSemicolon, after)) return true;
  Error(Peek(name_at).span(), diag::FunctionInsideFunction, Text(Peek(name_at).name()));
  leaving_function_ = !aborted_;
  if (leaving_function_) pos_ = specifiers.start;
  return false;
}

StmtId Parser::ParseFunctionBody() {
  if (bodies_ == FunctionBodies::kSkip) {
    const std::size_t start = pos_;
    SkipBalanced();
    return AddStmt(start, BlockStmt{});
  }
  const StmtId body = ParseBlock();
  if (leaving_function_) {
    leaving_function_ = false;
    EndPanic();
  }
  return body;
}

void Parser::ParseFunctionName(FunctionDecl& function) {
  const std::size_t start = pos_;
  if (AtDeclaratorScope())
    function.template_arguments = ParseDeclaratorScope(function.out_of_line_of);
  const std::size_t name_at = pos_;
  if (AtWord(Word::kOperator)) {
    function.name = ParseOperatorName();
  } else if (!ParseDeclaratorName(function.name, function.name_span, "function")) {
    return;
  }
  function.name_span = SpanFrom(function.out_of_line_of.name ? start : name_at);
  if (At(kLess)) function.template_arguments = ParseTemplateArguments();
}

// operator+, operator(), operator[]
Name Parser::ParseOperatorName() {
  Next();
  std::string text = "operator";
  const auto take = [&] {
    Next();
    text += PreviousText();
  };
  if ((At(kLeftParen) && At(kRightParen, 1)) || (At(kLeftBracket) && At(kRightBracket, 1))) {
    take();
    take();
  } else {
    while (!At(kLeftParen) && !At(kSemicolon) && !At(kLeftBrace) && !AtEnd()) take();
  }
  return Intern(text);
}

// (in float4 a, uniform int b = 1), or (void)
List<DeclId> Parser::ParseParameters() {
  const std::size_t open = pos_;
  Collector parameters(decls_);
  if (!Expect(kLeftParen, "`(`")) return {};
  if (TextAt() == "void" && At(kRightParen, 1)) Next();
  ParseList(kRightParen, open, "a parameter", [&] { ParseParameter(parameters); });
  return parameters.Finish();
}

void Parser::ParseParameter(Decls& decls) {
  Specifiers specifiers;
  if (!ParseTypedSpecifiers(specifiers, "a parameter")) return;
  CheckAttributes(specifiers.attributes, AttributeOwner::kParameter, "a parameter");
  VarDecl var = MakeVar(specifiers);
  if (At(kIdentifier) && !ParseDeclaratorName(var.name, var.name_span, "parameter")) return;
  CheckQualifiers(specifiers.qualifiers, QualifierOwner::kParameter,
                  var.name ? var.name_span : SpanFrom(specifiers.start));
  Declare(var.name, Meaning::kValue);
  ParseDeclaratorTail(var, Scope::kLocal);
  decls.Add(AddDecl(specifiers.start, var));
}

}  // namespace clipc::ast
