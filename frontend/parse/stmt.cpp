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
  const StmtId stmt = ParseUnattributed(start);
  if (!attributes.empty()) file_.stmts[stmt].attributes = attributes;
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

// Parses (condition), after the word `of`.
ExprId Parser::ParseCondition(std::string_view of) {
  if (At(kLeftParen)) return ParseInBrackets(kRightParen);
  Unexpected(fmt::format("`(` after `{}`", of));
  return ErrorExprHere();
}

// A chain of else-ifs is one path of the tree; the parser reads it in a loop.
StmtId Parser::ParseIf(std::size_t start) {
  struct Arm {
    std::size_t start;
    List<Attr> attributes;
    ExprId condition;
    StmtId then;
  };
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
    otherwise = AddStmt(arm.start, IfStmt{arm.condition, arm.then, otherwise});
    file_.stmts[otherwise].attributes = arm.attributes;
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
  WhileStmt loop{};
  loop.condition = ParseCondition("while");
  loop.body = ParseBody("while (...)");
  return AddStmt(start, loop);
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
  loop.condition = ParseCondition("while");
  ExpectSemicolon("`do ... while (...)`");
  return AddStmt(start, loop);
}

StmtId Parser::ParseSwitch() {
  const std::size_t start = pos_;
  Next();
  SwitchStmt statement{};
  statement.value = ParseCondition("switch");
  if (!panic_ && !At(kLeftBrace)) Unexpected("`{` after `switch (...)`");
  if (panic_) return AddStmt(start, ErrorStmt{});
  statement.body = ParseStatement();
  return AddStmt(start, statement);
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
