// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "frontend/parse/ast.h"

// The printer behind PrintAst(). Included by ast_print*.cpp only.
namespace clipc::ast {

class Printer {
 public:
  explicit Printer(const File& file) : file_(file) {}
  std::string Print();

 private:
  template <typename... Args>
  void Put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }
  void StartLine() { out_.append(static_cast<std::size_t>(indent_) * 2, ' '); }
  void EndLine() { out_ += '\n'; }
  std::string_view Text(Name name) const { return file_.names[name]; }

  void Put(const QualifiedName& name);
  void PutType(TypeId id);
  void PutExpr(ExprId id);
  void PutList(List<ExprId> list, std::string_view open, std::string_view close);
  void PutTemplateArguments(List<ExprId> list);
  void PutDimensions(List<ExprId> list);
  void PutQualifiers(Qualifiers qualifiers);
  void PutRegisters(List<RegisterBinding> registers);
  void PutLiteral(const Literal& literal);
  void PutVar(std::string_view kind, const VarDecl& var);
  void PutTemplate(List<TemplateParameter> parameters);
  void PutAttributes(List<Attr> attributes);
  void PutDecl(DeclId id, std::string_view variable);
  void PutDecls(List<DeclId> decls, std::string_view variable);
  void PutInlineType(TypeId id);
  void PutFunction(const FunctionDecl& function);
  void PutStruct(const StructDecl& structure);
  void PutBuffer(const BufferDecl& buffer);
  void PutEnum(const EnumDecl& decl);
  void PutStmt(StmtId id);
  void PutBody(StmtId id);
  void PutLine(std::string_view text, ExprId expr = {});
  void PutFor(const ForStmt& loop);

  const File& file_;
  std::string out_;
  int indent_ = 0;
};

}  // namespace clipc::ast
