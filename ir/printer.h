// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ir/program.h"

namespace clipc::ir {

// A printer of declarations, functions, statements and expressions of one program, as print.h
// describes, into one text.
class Printer {
 public:
  explicit Printer(const Program& program);

  std::string Take() { return std::move(text_); }
  void Line(std::string_view text);  // at the present indentation
  // "static const float3 name = init": storage where it says something, type, name, and the
  // initialiser if there is one.
  std::string Declaration(VarId var, ExprId init = {});
  std::string Declarator(TypeId type, const std::string& name) const;  // "float4 planes[2]"
  std::string ExprText(ExprId expr);
  void PrintFunction(FunctionId id, std::string_view role);

 private:
  // An operand of an operator, which is put in parentheses where it needs them.
  struct Operand {
    ExprId expr;
  };

  template <typename... Parts>
    requires(sizeof...(Parts) > 1)
  void Put(const Parts&... parts) {
    (Put(parts), ...);
  }
  void Put(std::string_view text) { text_ += text; }
  void Put(ExprId expr);
  void Put(Operand operand);
  void Put(List<ExprId> list);  // with commas between
  void PutLiteral(const Type& type, std::uint64_t bits);
  void PutUnary(const Unary& node);
  void PutField(const FieldRef& node);
  void PutObjectCall(const ObjectCall& node);

  void PutStmt(StmtId stmt);
  void PutBody(StmtId stmt);  // the statements of a block without its braces, one step further in
  void PutFor(const For& node);
  void PutSwitch(const Switch& node);

  std::string NameOf(VarId var) const;
  std::string NameOf(FunctionId function) const;

  const Program& program_;
  std::vector<std::uint32_t> var_suffixes_, function_suffixes_;
  std::string text_;
  int indent_ = 0;
};

}  // namespace clipc::ir
