// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <variant>

#include "base/overloaded.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// pre_increment(m) { m[0]++; m[1]++; return m; }
// post_increment(m) { before = m; m[0]++; m[1]++; return before; }
void BecomeStep(Legalizer& legalizer, ExprId expr, const Unary& node) {
  const bool is_prefix = node.op == UnaryOp::kPreIncrement || node.op == UnaryOp::kPreDecrement;
  const bool is_increment = node.op == UnaryOp::kPreIncrement || node.op == UnaryOp::kPostIncrement;
  const TypeId type = legalizer.program.exprs[expr].type;
  const std::string name =
      std::string(is_prefix ? "pre_" : "post_") + (is_increment ? "increment" : "decrement");
  const Parameter parameter{"m", type, Storage::kInOut};
  legalizer.BecomeCall(expr, name, {&parameter, 1}, {&node.operand, 1},
                       [&, op = node.op](HelperBody& body) {
                         const VarId before = is_prefix ? VarId{} : body.b.Local("before", type);
                         if (before) body.Add(body.b.Stmt(Declare{before, body[0]}));
                         for (std::uint32_t i = 0; i < legalizer.program.types[type].rows; ++i) {
                           body.Do(body.b.UnaryOf(op, body.b.At(body[0], i)));
                         }
                         body.Return(before ? body.b.Ref(before) : body[0]);
                       });
}

void LowerUnary(Legalizer& legalizer, ExprId expr, const Unary& node) {
  switch (node.op) {
    case UnaryOp::kNegate: return legalizer.ByRows(expr, "negate");
    case UnaryOp::kNot: return legalizer.ByRows(expr, "logical_not");
    case UnaryOp::kComplement: return legalizer.ByRows(expr, "complement");
    default: return BecomeStep(legalizer, expr, node);
  }
}

void LowerConvert(Legalizer& legalizer, ExprId expr, const Convert& node) {
  const Shape from = legalizer.ShapeAt(node.operand), to = legalizer.ShapeAt(expr);
  const bool has_unsigned = !legalizer.needs.signed_integers;
  const bool both_matrices = from.kind == Shape::kMatrix && to.kind == Shape::kMatrix;
  if (both_matrices || NameOf(from, has_unsigned) == NameOf(to, has_unsigned)) return;
  legalizer.ByRows(expr, "to_" + NameOf(to.Component()));
}

// Whether the function does not work component by component: LowerMatrixFunctions and
// LowerWrittenArguments lower such functions.
bool IsOfWholeMatrix(const Program& program, const IntrinsicCall& call) {
  if (CategoryOf(call.op) == IntrinsicCategory::kVectors) return true;
  for (std::size_t i = 0; i < program.expr_lists[call.arguments].size(); ++i) {
    if (WritesArgument(call.op, i)) return true;
  }
  return false;
}

}  // namespace

void LowerMatrixOperators(Legalizer& legalizer) {
  const Program& program = legalizer.program;
  const auto shape_of = [&](ExprId expr) {
    return legalizer.IsNumeric(expr) ? legalizer.ShapeAt(expr) : Shape{};
  };
  legalizer.ForEach([&](ExprId expr) {
    const auto& node = program.exprs[expr].node;
    if (const auto* binary = std::get_if<Binary>(&node)) {
      const Shape shape = shape_of(binary->left);
      if (shape.HasRows() && (shape.kind == Shape::kRows || !IsLinear(binary->op))) {
        legalizer.ByRows(expr, NameOf(binary->op));
      }
    } else if (const auto* unary = std::get_if<Unary>(&node)) {
      if (shape_of(expr).kind == Shape::kRows) LowerUnary(legalizer, expr, Unary(*unary));
    } else if (std::holds_alternative<Select>(node)) {
      if (shape_of(expr).HasRows()) legalizer.ByRows(expr, "select");
    } else if (const auto* convert = std::get_if<Convert>(&node)) {
      if (shape_of(expr).HasRows()) LowerConvert(legalizer, expr, Convert(*convert));
    } else if (const auto* call = std::get_if<IntrinsicCall>(&node)) {
      if (shape_of(program.expr_lists[call->arguments][0]).HasRows() &&
          !IsOfWholeMatrix(program, *call)) {
        legalizer.ByRows(expr, NameOf(call->op));
      }
    }
  });
}

}  // namespace clipc::legalize
