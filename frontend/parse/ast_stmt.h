// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <variant>

#include "frontend/parse/ast_expr.h"

// Statements of the syntax tree. An id is never none unless its comment says so.
namespace clipc::ast {

struct BlockStmt {
  List<StmtId> body;
};
// A statement that declares the variables of one declaration; or one struct, typedef, `using` or
// prototype.
struct DeclStmt {
  List<DeclId> decls;
};
struct ExprStmt {
  ExprId expr;
};
struct IfStmt {
  ExprId condition;
  StmtId then;
  StmtId otherwise;  // or none
};
struct ForStmt {
  StmtId init;       // a DeclStmt, an ExprStmt or none
  ExprId condition;  // or none
  ExprId step;       // or none
  StmtId body;
};
struct WhileStmt {
  ExprId condition;
  StmtId body;
};
struct DoStmt {
  StmtId body;
  ExprId condition;
};
// A switch statement, whose body is a BlockStmt with CaseStmts among its statements as labels.
struct SwitchStmt {
  ExprId value;
  StmtId body;
};
// The label `case value:` or `default:`. The statements that it labels follow it in the block.
struct CaseStmt {
  ExprId value;  // none: `default:`
};
struct ReturnStmt {
  ExprId value;  // or none
};
struct BreakStmt {};
struct ContinueStmt {};
struct DiscardStmt {};
struct EmptyStmt {};
// A statement that the parser reported an error for.
struct ErrorStmt {};

struct Stmt {
  Span span;
  List<Attr> attributes;
  std::variant<BlockStmt, DeclStmt, ExprStmt, IfStmt, ForStmt, WhileStmt, DoStmt, SwitchStmt,
               CaseStmt, ReturnStmt, BreakStmt, ContinueStmt, DiscardStmt, EmptyStmt, ErrorStmt>
      node;
};

}  // namespace clipc::ast
