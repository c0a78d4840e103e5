// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <fmt/format.h>

#include "frontend/parse/parser.h"

// Statements.
namespace clipc::ast {

// Parses one statement with its attributes. After an error the next statement can be read.
StmtId Parser::ParseStatement() {
  const std::size_t start = pos_;
  Nesting nesting(*this);
  if (!nesting.ok()) return AddStmt(start, ErrorStmt{});
  const List<Attr> attributes = ParseAttributes();
  CheckStatementAttributes(attributes);
  const bool is_block = At(kLeftBrace);
  const StmtId stmt = ParseUnattributed(start);
  if (!attributes.empty()) {
    // Those of `if (float x = f())` are at the `if`, after the declaration.
    const auto* with_declaration = std::get_if<BlockStmt>(&file_.stmts[stmt].node);
    const bool is_inside = with_declaration && !is_block;
    file_.stmts[is_inside ? file_.stmt_lists[with_declaration->body].back() : stmt].attributes =
        attributes;
  }
  if (panic_ && !leaving_function_) SkipStatement();
  return stmt;
}

void Parser::CheckStatementAttributes(List<Attr> list) {
  if (list.empty()) return;
  CheckAttributes(list, AttributeOwner::kOther, "a statement");
  if (panic_) return;  // the statement after an error is not the one that they are written at
  StatementKind kind = StatementKind::kOther;
  std::string_view what = "this statement";
  switch (WordAt()) {
    case Word::kFor:
    case Word::kWhile:
    case Word::kDo: kind = StatementKind::kLoop, what = "a loop"; break;
    case Word::kIf: kind = StatementKind::kIf, what = "an `if`"; break;
    case Word::kSwitch: kind = StatementKind::kSwitch, what = "a `switch`"; break;
    default: break;
  }
  const auto attributes = file_.attrs[list];
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const std::string_view name = Text(attributes[i].name);
    if (!MayStandAt(name, kind))
      diagnostics_.Report(attributes[i].name_span, diag::AttributeMisplaced, name, what);
    for (const Attr& before : attributes.first(i)) {
      if (Contradict(Text(before.name), name))
        diagnostics_.Report(attributes[i].name_span, diag::AttributeConflict, Text(before.name),
                            name);
    }
  }
}

StmtId Parser::ParseUnattributed(std::size_t start) {
  if (panic_) return AddStmt(start, ErrorStmt{});
  if (At(kLeftBrace)) return ParseBlock();
  if (Accept(kSemicolon)) return AddStmt(start, EmptyStmt{});
  switch (WordAt()) {
    case Word::kIf: return ParseIf(start);
    case Word::kFor: return ParseFor();
    case Word::kWhile: return ParseWhile();
    case Word::kDo: return ParseDo();
    case Word::kSwitch: return ParseSwitch();
    case Word::kCase:
    case Word::kDefault: return ParseCase();
    case Word::kReturn: return ParseReturn();
    case Word::kBreak:
    case Word::kContinue:
    case Word::kDiscard: return ParseSimple();
    case Word::kElse:
      Error(Here(), diag::ElseWithoutIf);
      Next();
      EndPanic();
      return AddStmt(start, ErrorStmt{});
    default: break;
  }
  return ParseDeclOrExpr();
}

StmtId Parser::ParseBlock() {
  const std::size_t open = pos_;
  Accept(kLeftBrace);
  NameScope scope(*this);
  Collector body(stmts_);
  while (!At(kRightBrace) && !AtEnd() && !leaving_function_) {
    const bool outside = AtAnyOf(kOutsideWords | Word::kTechnique) && AtDeclarationWord();
    if (outside && !panic_) {
      ExpectClose(kRightBrace, open);
      leaving_function_ = !aborted_;
      break;
    }
    const std::size_t before = pos_;
    body.Add(ParseStatement());
    if (pos_ == before && !leaving_function_) Next();
  }
  if (!leaving_function_) ExpectClose(kRightBrace, open);
  return AddStmt(open, BlockStmt{body.Finish()});
}

// Parses the statement that a loop or branch governs, after `of`.
StmtId Parser::ParseBody(std::string_view of) {
  NameScope scope(*this);
  if (At(kRightBrace) || AtEnd()) Unexpected(fmt::format("a statement after `{}`", of));
  if (panic_) return AddStmt(pos_, ErrorStmt{});
  return ParseStatement();
}

// Whether the text goes on with `(float x =`.
bool Parser::AtConditionDeclaration() const {
  const bool may_be_type = At(kIdentifier, 2) || At(kLess, 2) || At(kColonColon, 2);
  if (!At(kLeftParen) || !may_be_type) return false;
  const std::size_t after = SkipTypeName(SkipQualifiers(1));
  return after != 0 && At(kIdentifier, after) && At(kEqual, after + 1);
}

// Parses (condition) or (float x = value), after the word `of`. dxc takes a declaration as C++ does
// (DXC's CodeGenSPIRV/cf.if.plain.hlsl).
Parser::Condition Parser::ParseCondition(std::string_view of) {
  if (!At(kLeftParen)) {
    Unexpected(fmt::format("`(` after `{}`", of));
    return {ErrorExprHere(), {}};
  }
  if (!AtConditionDeclaration()) return {ParseInBrackets(kRightParen), {}};
  const std::size_t open = pos_;
  Next();
  Bracketed bracketed(*this);
  const std::size_t start = pos_;
  Collector decls(decls_);
  VarDecl var = MakeVar(ParseSpecifiers("a declaration"));
  const std::size_t name_at = pos_;
  if (panic_ || !ParseDeclaratorName(var.name, var.name_span, "variable"))
    return {ErrorExprHere(), {}};
  Declare(var.name, Meaning::kValue);
  const ExprId value = AddExpr(name_at, NameExpr{{var.name, {}, false}, {}});
  ParseDeclaratorTail(var, Scope::kLocal);
  decls.Add(AddDecl(start, var));
  const StmtId declared = AddStmt(start, DeclStmt{decls.Finish()});
  ExpectClose(kRightParen, open);
  return {value, declared};
}

// The statement after the declaration of its condition, if there is one: `if (float x = f()) ..` is
// { float x = f(); if (x) .. }.
StmtId Parser::AfterDeclaration(std::size_t start, const Condition& condition, StmtId stmt) {
  if (!condition.declared) return stmt;
  Collector body(stmts_);
  body.Add(condition.declared);
  body.Add(stmt);
  return AddStmt(start, BlockStmt{body.Finish()});
}

// A chain of else-ifs is one path of the tree; the parser reads it in a loop.
StmtId Parser::ParseIf(std::size_t start) {
  struct Arm {
    std::size_t start;
    List<Attr> attributes;
    Condition condition;
    StmtId then;
  };
  NameScope scope(*this);
  std::vector<Arm> arms;
  const int depth_before = depth_;
  List<Attr> attributes;
  StmtId otherwise;
  while (true) {
    Next();
    Arm arm{start, attributes, ParseCondition("if"), {}};
    arm.then = ParseBody("if (...)");
    arms.push_back(arm);
    if (panic_ || !AtWord(Word::kElse)) break;
    Next();
    start = pos_;
    attributes = ParseAttributes();
    CheckStatementAttributes(attributes);
    if (!AtWord(Word::kIf)) {
      otherwise = ParseBody("else");
      if (!attributes.empty()) file_.stmts[otherwise].attributes = attributes;
      break;
    }
    Nesting level(*this);
    if (!level.ok()) break;
    ++depth_;
  }
  depth_ = depth_before;
  while (!arms.empty()) {
    const Arm& arm = arms.back();
    otherwise = AddStmt(arm.start, IfStmt{arm.condition.value, arm.then, otherwise});
    file_.stmts[otherwise].attributes = arm.attributes;
    otherwise = AfterDeclaration(arm.start, arm.condition, otherwise);
    arms.pop_back();
  }
  return otherwise;
}

StmtId Parser::ParseFor() {
  const std::size_t start = pos_;
  NameScope scope(*this);
  Next();
  ForStmt loop{};
  const std::size_t open = pos_;
  if (!Expect(kLeftParen, "`(` after `for`")) return AddStmt(start, ErrorStmt{});
  if (!Accept(kSemicolon)) loop.init = ParseDeclOrExpr();
  if (!At(kSemicolon) && !panic_) loop.condition = ParseExpression();
  if (!panic_) Expect(kSemicolon, "`;` after the condition of `for`");
  if (!At(kRightParen) && !panic_) loop.step = ParseExpression();
  if (!ExpectClose(kRightParen, open)) SkipToClose(kRightParen, true);
  loop.body = ParseBody("for (...)");
  return AddStmt(start, loop);
}

StmtId Parser::ParseWhile() {
  const std::size_t start = pos_;
  Next();
  NameScope scope(*this);
  const Condition condition = ParseCondition("while");
  const StmtId body = ParseBody("while (...)");
  if (!condition.declared) return AddStmt(start, WhileStmt{condition.value, body});
  // while (float x = f()) {..}  =>  while (true) { float x = f(); if (!x) break; {..} }
  Collector stmts(stmts_);
  stmts.Add(condition.declared);
  const ExprId ends = AddExpr(start, UnaryExpr{UnaryOp::kNot, condition.value});
  stmts.Add(AddStmt(start, IfStmt{ends, AddStmt(start, BreakStmt{}), {}}));
  stmts.Add(body);
  const ExprId always = AddExpr(start, Literal{LiteralKind::kBool, 1});
  return AddStmt(start, WhileStmt{always, AddStmt(start, BlockStmt{stmts.Finish()})});
}

StmtId Parser::ParseDo() {
  const std::size_t start = pos_;
  Next();
  DoStmt loop{};
  loop.body = ParseBody("do");
  if (panic_) return AddStmt(start, ErrorStmt{});
  if (!AtWord(Word::kWhile)) {
    Unexpected("`while` after the body of `do`");
    return AddStmt(start, ErrorStmt{});
  }
  Next();
  loop.condition = At(kLeftParen) ? ParseInBrackets(kRightParen) : ParseCondition("while").value;
  ExpectSemicolon("`do ... while (...)`");
  return AddStmt(start, loop);
}

StmtId Parser::ParseSwitch() {
  const std::size_t start = pos_;
  Next();
  NameScope scope(*this);
  SwitchStmt statement{};
  const Condition condition = ParseCondition("switch");
  statement.value = condition.value;
  if (!panic_ && !At(kLeftBrace)) Unexpected("`{` after `switch (...)`");
  if (panic_) return AddStmt(start, ErrorStmt{});
  statement.body = ParseStatement();
  return AfterDeclaration(start, condition, AddStmt(start, statement));
}

StmtId Parser::ParseCase() {
  const std::size_t start = pos_;
  const bool has_value = Next().name() == Intern("case");
  CaseStmt label{};
  if (has_value) label.value = ParseConditional();
  Expect(kColon, has_value ? "`:` after the value of `case`" : "`:` after `default`");
  return AddStmt(start, label);
}

StmtId Parser::ParseReturn() {
  const std::size_t start = pos_;
  Next();
  ReturnStmt statement{};
  if (!At(kSemicolon) && !At(kRightBrace)) statement.value = ParseExpression();
  ExpectSemicolon("`return`");
  return AddStmt(start, statement);
}

StmtId Parser::ParseSimple() {
  const std::size_t start = pos_;
  const Word word = WordAt();
  const std::string_view text = Text(Next().name());
  ExpectSemicolon(fmt::format("`{}`", text));
  switch (word) {
    case Word::kBreak: return AddStmt(start, BreakStmt{});
    case Word::kContinue: return AddStmt(start, ContinueStmt{});
    default: return AddStmt(start, DiscardStmt{});
  }
}

// float x = 1;  x += 1;
StmtId Parser::ParseDeclOrExpr() {
  const std::size_t start = pos_;
  if (IsDeclaration()) {
    Collector decls(decls_);
    if (!ParseKeywordDeclaration(decls, Scope::kLocal)) ParseSpecified(decls, Scope::kLocal, {});
    return AddStmt(start, DeclStmt{decls.Finish()});
  }
  const ExprId expr = ParseExpression();
  ExpectSemicolon("the expression");
  return AddStmt(start, ExprStmt{expr});
}

}  // namespace clipc::ast
