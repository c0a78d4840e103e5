// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/parser.h"

// Functions, their parameters and templates.
namespace clipc::ast {

// template<typename T, uint N = 2> before a struct, a function or a variable
void Parser::ParseTemplate(Decls& decls, Scope scope) {
  Next();
  const std::size_t open = pos_;
  if (!Expect(TokenKind::kLess, "`<`")) return;
  NameScope names(*this);
  Nesting nesting(*this, 0);
  if (!nesting.ok()) return;
  TemplateHeader header;
  header.present = true;
  Collector<TemplateParameter> parameters(template_parameter_stack_);
  while (!At(TokenKind::kGreater) && !AtEnd()) {
    parameters.Add(ParseTemplateParameter());
    if (panic_ || !Accept(TokenKind::kComma)) break;
  }
  if (!ExpectClose(TokenKind::kGreater, open)) return;
  header.parameters = parameters.Finish(file_.template_parameters);
  const bool structure = (AtWord(Word::kStruct) || AtWord(Word::kClass)) && AtName(1) &&
                         Peek(2).kind != TokenKind::kIdentifier;
  if (structure) {
    const DeclId definition = ParseStruct(header);
    decls.Add(definition);
    ParseEndOfType(definition);
  } else if (AtWord(Word::kUsing)) {
    ParseUsing(decls);
  } else {
    ParseSpecified(decls, scope, header);
  }
}

TemplateParameter Parser::ParseTemplateParameter() {
  const std::size_t start = pos_;
  TemplateParameter parameter{};
  parameter.is_type = AtWord(Word::kTypename) || AtWord(Word::kClass);
  if (parameter.is_type)
    Next();
  else
    parameter.type = ParseSpecifiers("a template parameter").type;
  if (AtName()) parameter.name = Next().name();
  Declare(parameter.name, parameter.is_type ? Meaning::kType : Meaning::kValue);
  if (Accept(TokenKind::kEqual)) parameter.default_value = ParseTemplateArgument();
  parameter.span = SpanFrom(start);
  return parameter;
}

// `S::` or `S<T>::` before the name that is declared.
bool Parser::AtDeclaratorScope() const {
  if (!AtName() || WordAt() == Word::kOperator) return false;
  if (Peek(1).kind == TokenKind::kColonColon) return true;
  if (Peek(1).kind != TokenKind::kLess) return false;
  const std::size_t after = SkipTemplateArguments(1);
  return after != 0 && Peek(after).kind == TokenKind::kColonColon;
}

// Returns the arguments of `S<T>::`.
List<ExprId> Parser::ParseDeclaratorScope(QualifiedName& scope) {
  Collector<Name> scopes(name_stack_);
  List<ExprId> arguments;
  while (AtDeclaratorScope() && !panic_) {
    scopes.Add(Next().name());
    if (At(TokenKind::kLess)) arguments = ParseTemplateArguments();
    Accept(TokenKind::kColonColon);
  }
  scope.name = scopes.last();
  scopes.RemoveLast();
  scope.scopes = scopes.Finish(file_.name_lists);
  return arguments;
}

// `name(`, `S::name(`, `name<float>(` or an operator.
bool Parser::AtFunctionDeclarator() const {
  std::size_t i = 0;
  while (Peek(i).kind == TokenKind::kIdentifier) {
    if (WordAt(i) == Word::kOperator) return true;
    ++i;
    if (Peek(i).kind == TokenKind::kLess) {
      const std::size_t after = SkipTemplateArguments(i);
      if (after != 0) i = after;
    }
    if (Peek(i).kind == TokenKind::kLeftParen) return true;
    if (Peek(i).kind != TokenKind::kColonColon) return false;
    ++i;
  }
  return false;
}

// From the name on.
void Parser::ParseFunction(Decls& decls, Scope scope, const Specifiers& specifiers,
                           const TemplateHeader& header) {
  FunctionDecl function{};
  function.return_type = specifiers.type;
  function.qualifiers = specifiers.qualifiers;
  function.attributes = specifiers.attributes;
  function.template_parameters = header.parameters;
  function.is_template = header.present;
  if (scope == Scope::kLocal && !ParseLocalFunction(specifiers)) return;
  ParseFunctionName(function);
  if (panic_) return;
  if (!function.out_of_line_of.name) {
    Declare(function.name, header.present ? Meaning::kFunctionTemplate : Meaning::kFunction);
  }
  NameScope names(*this);
  function.parameters = ParseParameters();
  function.return_dimensions = ParseDimensions();
  function.is_const_method =
      AtWord(Word::kQualifier) && InfoOfName(Peek().name()).qualifier == kConst;
  if (function.is_const_method) Next();
  Collector<RegisterBinding> ignored(register_stack_);
  VarDecl parts{};
  while ((At(TokenKind::kColon) || At(TokenKind::kLess)) && !panic_) {
    if (At(TokenKind::kLess))
      SkipAnnotation();
    else
      ParseColonPart(parts, ignored);
  }
  function.return_semantic = parts.semantic;
  if (panic_ && At(TokenKind::kLeftBrace)) panic_ = aborted_;
  if (At(TokenKind::kLeftBrace) && !panic_) {
    function.body = ParseFunctionBody();
  } else if (!panic_ && !At(TokenKind::kSemicolon)) {
    Unexpected(fmt::format("`{{` or `;` after the header of `{}`", Text(function.name)));
    // A forgotten `{`: the body is read as if it were there.
    if (IsStatementWord(WordAt())) {
      panic_ = aborted_;
      function.body = ParseFunctionBody();
    }
  } else {
    Accept(TokenKind::kSemicolon);
  }
  decls.Add(AddDecl(specifiers.start, function));
}

// Inside a function: true for a prototype. A definition means that a `}` is missing before it; the
// text is read on as if it were there.
bool Parser::ParseLocalFunction(const Specifiers& specifiers) {
  std::size_t name_at = 0;
  while (Peek(name_at + 1).kind == TokenKind::kColonColon) name_at += 2;
  const std::size_t first = name_at + 2;
  const bool has_parameters =
      Peek(first).kind == TokenKind::kRightParen || SkipQualifiers(first) > first ||
      (StartsType(first) && Peek(first + 1).kind != TokenKind::kLeftParen) ||
      (AtName(first) && AtName(first + 1));
  if (!has_parameters) {  // float3 x(1, 2, 3);
    for (std::size_t i = 0; i <= name_at; ++i) Next();
    Unexpected("`;` or `=` after the name of a variable");
    return false;
  }
  const std::size_t after = SkipBrackets(name_at + 1);
  if (after != 0 && Peek(after).kind == TokenKind::kSemicolon) return true;
  Error(Peek(name_at).span(), diag::FunctionInsideFunction, Text(Peek(name_at).name()));
  leaving_function_ = !aborted_;
  if (leaving_function_) pos_ = specifiers.start;
  return false;
}

StmtId Parser::ParseFunctionBody() {
  const StmtId body = ParseBlock();
  if (leaving_function_) {
    leaving_function_ = false;
    panic_ = aborted_;
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
  if (At(TokenKind::kLess)) function.template_arguments = ParseTemplateArguments();
}

// operator+, operator(), operator[]
Name Parser::ParseOperatorName() {
  Next();
  std::string text = "operator";
  if (At(TokenKind::kLeftParen) && Peek(1).kind == TokenKind::kRightParen) {
    text += "()";
    Next();
    Next();
  } else if (At(TokenKind::kLeftBracket) && Peek(1).kind == TokenKind::kRightBracket) {
    text += "[]";
    Next();
    Next();
  } else {
    while (!At(TokenKind::kLeftParen) && !At(TokenKind::kSemicolon) && !At(TokenKind::kLeftBrace) &&
           !AtEnd()) {
      Next();
      text += PreviousText();
    }
  }
  return Intern(text);
}

List<DeclId> Parser::ParseParameters() {
  const std::size_t open = pos_;
  Decls parameters(decl_stack_);
  if (!Expect(TokenKind::kLeftParen, "`(`")) return {};
  const bool is_void = AtWord(Word::kNumericType) && Text(Peek().name()) == "void" &&
                       Peek(1).kind == TokenKind::kRightParen;
  if (is_void) Next();
  while (!At(TokenKind::kRightParen) && !AtEnd()) {
    ParseParameter(parameters);
    if (panic_ || !Accept(TokenKind::kComma)) break;
    if (At(TokenKind::kRightParen)) Unexpected("a parameter");
  }
  if (!panic_ && !At(TokenKind::kRightParen)) {
    Diagnostic* report = Error(Here(), diag::UnexpectedToken, Describe(), "`,` or `)`");
    if (report) report->Note(tokens_[open].span(), diag::OpenedHere, "(");
  }
  if (panic_)
    SkipToClose(TokenKind::kRightParen);
  else
    Next();
  return parameters.Finish(file_.decl_lists);
}

void Parser::ParseParameter(Decls& decls) {
  const Specifiers specifiers = ParseSpecifiers("a parameter");
  if (panic_) return;
  VarDecl var{};
  if (!specifiers.type) {
    Unexpected("a parameter");
    return;
  }
  var.type = specifiers.type;
  var.qualifiers = specifiers.qualifiers;
  var.attributes = specifiers.attributes;
  if (At(TokenKind::kIdentifier) && !ParseDeclaratorName(var.name, var.name_span, "parameter"))
    return;
  Declare(var.name, Meaning::kValue);
  ParseDeclaratorTail(var, Scope::kLocal);
  decls.Add(AddDecl(specifiers.start, var));
}

}  // namespace clipc::ast
