// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ir/program.h"

namespace clipc::ir {

// Prints declarations, functions, statements and expressions of one program, as print.h describes,
// into one text.
class Printer {
 public:
  explicit Printer(const Program& program);

  std::string Take() { return std::move(text_); }
  void Line(std::string_view text);  // at the present indentation
  // "static const float3 name": storage where it says something, type and name.
  std::string Declaration(VarId var) const;
  std::string Declarator(TypeId type, const std::string& name) const;  // "float4 planes[2]"
  std::string ExprText(ExprId expr);
  void PrintFunction(FunctionId id, std::string_view role);

 private:
  void Put(std::string_view text) { text_ += text; }
  void PutList(List<ExprId> list);
  void PutCall(std::string_view name, List<ExprId> arguments);
  void PutLiteral(const Type& type, std::uint64_t bits);
  void PutOperand(ExprId expr);  // in parentheses where it is an operator's expression
  void PutExpr(ExprId expr);
  void PutConstruct(TypeId type, List<ExprId> arguments);
  void PutUnary(const Unary& node);
  void PutNode(TypeId type, const decltype(Expr::node)& node);

  void PutStmt(StmtId stmt);
  void PutBody(StmtId stmt);  // the statements of a block without its braces, one step further in
  void PutFor(const For& node);
  void PutSwitch(const Switch& node);
  void StartLine() { text_.append(static_cast<std::size_t>(indent_) * 2, ' '); }

  std::string NameOf(VarId var) const;
  std::string NameOf(FunctionId function) const;

  const Program& program_;
  std::vector<std::uint32_t> var_suffixes_, function_suffixes_;
  std::string text_;
  int indent_ = 0;
};

}  // namespace clipc::ir
