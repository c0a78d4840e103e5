// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/program.h"

namespace clipc::ir {

// What is wrong with the types of a call of the intrinsic; nothing when they are what its signature
// promises. half and the minimum-precision kinds count as float, int or uint.
std::optional<std::string> CheckIntrinsic(const TypeTable& types, Intrinsic op, TypeId result,
                                          const std::vector<TypeId>& arguments);

// What a node of Form::kLegalized must not be; empty for a node that it may be.
std::string_view RuleBrokenBy(const Program& program, ExprId expr);

// Whether both are numeric and have the same rows and columns.
inline bool SameShape(const Type& a, const Type& b) {
  return a.IsNumeric() && a.kind == b.kind && a.rows == b.rows && a.columns == b.columns;
}

// The types of expressions. Remembers the first problem; after it, nothing else is checked.
class ExprVerifier {
 public:
  explicit ExprVerifier(const Program& program);

  // Checks the tree under `expr`, and that no other tree holds any of it.
  void CheckTree(ExprId expr);
  bool failed() const { return problem_.has_value(); }
  const std::optional<std::string>& problem() const { return problem_; }
  void Fail(std::string what);

  // Which variables may be named at the moment.
  enum class Scope : std::uint8_t { kNotYet, kVisible, kGone };
  std::vector<Scope> scope;
  // Whether Form::kLegalized is asked for.
  bool legalized = false;
  // Printed before a problem: "function main".
  std::string where;
  // The functions that the trees checked so far call.
  std::vector<FunctionId> calls;

 private:
  bool Require(bool holds, ExprId expr, std::string_view rule);
  const Type& TypeOf(ExprId expr) const { return program_.types[program_.exprs[expr].type]; }
  TypeId IdOf(ExprId expr) const { return program_.exprs[expr].type; }
  bool HasShapeOf(ExprId a, ExprId b) const;
  bool IsTarget(ExprId expr) const;
  std::vector<TypeId> TypesOf(List<ExprId> list) const;

  void CheckNode(ExprId expr);
  void RequireComponents(ExprId expr, const Type& base, std::uint8_t count);
  void CheckVarRef(ExprId expr, const VarRef& node);
  void CheckField(ExprId expr, const FieldRef& node);
  void CheckIndex(ExprId expr, const Index& node);
  void CheckSwizzle(ExprId expr, const Swizzle& node);
  void CheckMatrixSwizzle(ExprId expr, const MatrixSwizzle& node);
  void CheckUnary(ExprId expr, const Unary& node);
  void CheckBinary(ExprId expr, const Binary& node);
  void CheckAssign(ExprId expr, const Assign& node);
  void CheckChoice(ExprId expr, ExprId condition, ExprId when_true, ExprId when_false,
                   bool component_wise);
  void CheckConstruct(ExprId expr, const Construct& node);
  void CheckCall(ExprId expr, const Call& node);
  void CheckIntrinsicCall(ExprId expr, const IntrinsicCall& node);
  void CheckObjectCall(ExprId expr, const ObjectCall& node);

  const Program& program_;
  std::vector<bool> has_parent_;
  std::optional<std::string> problem_;
};

}  // namespace clipc::ir
