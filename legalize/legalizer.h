// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/access.h"
#include "ir/builder.h"
#include "ir/program.h"
#include "legalize/divisors.h"
#include "legalize/helper_body.h"
#include "legalize/needs.h"
#include "legalize/shape.h"

namespace clipc::legalize {

// The word for an operator in the names of helper functions: "multiply".
std::string_view NameOf(ir::BinaryOp op);
inline bool IsLinear(ir::BinaryOp op) {
  return op == ir::BinaryOp::kMul || op == ir::BinaryOp::kDiv || op == ir::BinaryOp::kAdd ||
         op == ir::BinaryOp::kSub;
}

// The state that the legalising passes share: the program, the target's needs, and the helper
// functions in place of operations that the target lacks.
class Legalizer {
 public:
  Legalizer(ir::Program& program, const Needs& needs);

  ir::Program& program;
  const Needs needs;

  const ir::Type& TypeOf(ir::ExprId expr) const { return program.types[program.exprs[expr].type]; }
  Shape ShapeAt(ir::ExprId expr) const { return ShapeOf(TypeOf(expr), needs); }
  bool IsNumeric(ir::ExprId expr) const { return TypeOf(expr).IsNumeric(); }
  // A builder whose nodes have the place of `expr` in the source.
  ir::Builder At(ir::ExprId expr) { return ir::Builder(program, program.exprs[expr].span); }
  // Whether `expr` may be evaluated twice, or not at all in some invocations.
  bool MayBeSkipped(ir::ExprId expr);

  // Whether the program names the least integer, which has no opposite. Others than those that it
  // names are not known to a GLSL compiler, so it does not divide them.
  bool NamesLeastInteger();

  // Whether divisions by 0 have Direct3D's results: those of Direct3D 10 and later, whose udiv has
  // them; before, an int is a float without a fraction. dxc's udiv of DXIL has them too in drivers
  // (dxil-spirv, pull request 300), and SPIR-V leaves more than the value undefined.
  bool GuardsDivisions() const;
  // Whether a division by the integers `divisor` needs a guard.
  bool MayDivideByZero(ir::ExprId divisor);

  // Component `i` of a vector, a matrix of one row or one column, or a scalar.
  ir::ExprId Component(ir::Builder b, ir::ExprId expr, int i);

  // Gives `expr` the node of `other`, which has the same type.
  void Become(ir::ExprId expr, ir::ExprId other) {
    program.exprs[expr].node = program.exprs[other].node;
  }

  // The helper function `name` for these parameters; `define` writes the body when there is no such
  // function yet.
  ir::FunctionId Helper(std::string_view name, std::span<const Parameter> parameters,
                        ir::TypeId result, const Define& define);
  // Makes `expr` a call of the helper function `name`.
  void BecomeCall(ir::ExprId expr, std::string_view name, std::span<const Parameter> parameters,
                  std::span<const ir::ExprId> arguments, const Define& define);
  // Makes `expr` a call of a function whose parameters are called a, b, c, d and have the
  // arguments' types.
  void BecomeCall(ir::ExprId expr, std::string_view name, std::span<const ir::ExprId> arguments,
                  const Define& define);

  // Makes `expr`, which does something for each component of its operands, a call of a helper
  // function that does `node` for each row, or each component, of its parameters. The operands of
  // `node` stand for those of `expr`, one for one.
  using Node = decltype(ir::Expr::node);
  void ByRows(ir::ExprId expr, std::string_view name) {
    ByParts(expr, name, program.exprs[expr].node, true);
  }
  void ByComponents(ir::ExprId expr, std::string_view name, Node node) {
    ByParts(expr, name, node, false);
  }

  // Calls visit(ExprId) for every expression of the program that a pass may change, and for those
  // that are added meanwhile.
  template <typename OnExpr>
  void ForEach(OnExpr&& visit) {
    for (const ir::ExprId expr : operations_) visit(expr);
    for (std::uint32_t i = first_new_; i < program.exprs.size(); ++i) visit(ir::ExprId{i});
  }

 private:
  void ByParts(ir::ExprId expr, std::string_view name, const Node& node, bool rows);
  ir::ExprId PartOf(HelperBody& body, const Node& node, ir::TypeId type, int part, bool rows);

  std::vector<ir::ExprId> operations_;  // original ones that a pass may change, in order of ExprId
  std::uint32_t first_new_;             // the first expression that a pass added
  Divisors divisors_;
  std::optional<bool> names_least_integer_;        // none: nothing has asked for it
  std::map<std::string, ir::FunctionId> helpers_;  // by name and types of parameters
  std::optional<ir::Effects> effects_;
  std::uint32_t effects_functions_ = 0;  // the number of functions that effects_ was made for
};

}  // namespace clipc::legalize
