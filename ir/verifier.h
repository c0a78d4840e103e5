// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/program.h"

namespace clipc::ir {

// Describes the mistake in the types of a call of the intrinsic; empty if they are what its
// signature promises. half and the minimum-precision kinds count as float, int or uint.
std::optional<std::string> CheckIntrinsic(const TypeTable& types, Intrinsic op, TypeId result,
                                          const std::vector<TypeId>& arguments);

// The rule of Form::kLegalized that the node breaks, in words; empty if it breaks none.
std::string_view RuleBrokenBy(const Program& program, ExprId expr);

// Whether both are numeric and have the same rows and columns.
inline bool SameShape(const Type& a, const Type& b) {
  return a.IsNumeric() && a.kind == b.kind && a.rows == b.rows && a.columns == b.columns;
}

inline bool IsOutputArray(const Program& program, VarId var) {
  return program.vars[var].storage == Storage::kOutput &&
         program.types[program.vars[var].type].kind == TypeKind::kArray;
}

// A verifier of the types of expressions. It remembers the first problem; after it, nothing else is
// checked.
class ExprVerifier {
 public:
  explicit ExprVerifier(const Program& program);

  // Checks the tree under `expr`, and that no other tree holds any of it.
  void CheckTree(ExprId expr);
  bool failed() const { return problem_.has_value(); }
  const std::optional<std::string>& problem() const { return problem_; }
  void Fail(std::string what);

  // The scope of each variable by VarId: whether it may be named at the moment.
  enum class Scope : std::uint8_t { kNotYet, kVisible, kGone };
  std::vector<Scope> scope;
  // Whether Form::kLegalized is asked for.
  bool legalized = false;
  // The text that is printed before a problem: "function main".
  std::string where;
  // The functions that the trees checked so far call.
  std::vector<FunctionId> calls;
  // The number of references to arrays of outputs in the trees checked so far.
  std::size_t output_arrays = 0;

 private:
  bool Require(bool holds, std::string_view rule);  // of `expr_`
  const Type& TypeOf(ExprId expr) const { return program_.types[program_.exprs[expr].type]; }
  TypeId IdOf(ExprId expr) const { return program_.exprs[expr].type; }
  const Type& Checked() const { return TypeOf(expr_); }
  bool HasShapeOf(ExprId a, ExprId b) const;
  bool IsTarget(ExprId expr) const;
  bool IsOperand(const ObjectCall& node, OperandKind kind, ExprId operand) const;
  bool IsResult(const ObjectCall& node) const;
  std::vector<TypeId> TypesOf(List<ExprId> list) const;
  void RequireComponents(const Type& base, std::uint8_t count);
  void RequireSides(ExprId when_true, ExprId when_false);

  // Each Check takes the node of `expr_`, whose operands were checked.
  void Check(const Literal& node);
  void Check(const Zero& node);
  void Check(const VarRef& node);
  void Check(const FieldRef& node);
  void Check(const Index& node);
  void Check(const Swizzle& node);
  void Check(const MatrixSwizzle& node);
  void Check(const Unary& node);
  void Check(const Binary& node);
  void Check(const Assign& node);
  void Check(const Conditional& node);
  void Check(const Select& node);
  void Check(const Convert& node);
  void Check(const Splat& node);
  void Check(const Construct& node);
  void Check(const MatrixTruncate& node);
  void Check(const Call& node);
  void Check(const IntrinsicCall& node);
  void Check(const ObjectCall& node);
  void Check(const Comma& node);

  const Program& program_;
  ExprId expr_;
  std::vector<bool> has_parent_;
  std::optional<std::string> problem_;
};

}  // namespace clipc::ir
