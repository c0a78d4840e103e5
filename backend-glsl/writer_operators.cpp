// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Operators on operands already written.
// What GLSL's operators do otherwise than HLSL's, or only for some types, is done by helper
// functions.
#include <optional>

#include "backend-glsl/writer.h"
#include "base/invariant.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

Operand Writer::OperandOf(ExprId id) {
  const ir::Expr& expr = program_.exprs[id];
  Operand operand{{}, ShapeAt(id), std::nullopt, ConstantOf(program_, id), false};
  if (const auto* splat = std::get_if<Splat>(&expr.node)) {
    operand.repeatable = IsRepeatable(splat->operand);
    operand.scalar = Expr(splat->operand);
  } else if (std::holds_alternative<Zero>(expr.node)) {
    operand.repeatable = true;
    operand.scalar = Text{ZeroText(operand.shape.Component())};
  } else if (std::holds_alternative<Literal>(expr.node)) {
    operand.repeatable = true;
    operand.scalar = Expr(id);
  } else {
    operand.repeatable = IsRepeatable(id);
    operand.text = Expr(id);
  }
  return operand;
}

std::vector<Operand> Writer::OperandsOf(List<ExprId> list) {
  std::vector<Operand> operands;
  operands.reserve(list.size);
  for (ExprId id : program_.expr_lists[list]) operands.push_back(OperandOf(id));
  return operands;
}

Text Writer::Full(const Operand& operand) {
  return operand.scalar ? SplatText(*operand.scalar, operand.shape, operand.repeatable,
                                    operand.constant && operand.constant->bits == 0)
                        : operand.text;
}

Text Writer::SplatText(const Text& scalar, const Shape& shape, bool repeatable, bool is_zero) {
  if (shape.IsScalar()) return scalar;
  const std::string type = TypeName(shape);
  if (shape.IsVector()) return {type + "(" + Argument(scalar) + ")"};
  if (!repeatable) {
    const std::string component = TypeName(shape.Component());
    const std::string name = Helper("splat_" + type, component, [&](const std::string& helper) {
      return type + " " + helper + "(" + component + " x) {\n    return " +
             SplatText({"x"}, shape, true).text + ";\n}\n";
    });
    return {name + "(" + Argument(scalar) + ")"};
  }
  // mat4(x) is x on the diagonal only.
  if (shape.kind == Shape::kMatrix && is_zero) return {type + "(" + scalar.text + ")"};
  std::string text = type + "(";
  for (int i = 0; i < shape.rows; ++i)
    text += (i > 0 ? ", " : "") + SplatText(scalar, shape.Row(), true).text;
  return {text + ")"};
}

Text Writer::UnaryOn(UnaryOp op, const Operand& operand) {
  if (op == UnaryOp::kNot && operand.shape.IsVector()) return CallOn("not", {&operand, 1});
  const char* spelling = op == UnaryOp::kNegate ? "-" : op == UnaryOp::kNot ? "!" : "~";
  std::string text = Full(operand).At(Binding::kUnary);
  // `--x` would be a decrement.
  if (text.starts_with(spelling) && op == UnaryOp::kNegate) text = "(" + text + ")";
  return {spelling + text, Binding::kUnary};
}

// A scalar operand may stand beside a vector or matrix as it is, but for the left one of a shift.
Text Writer::BinaryOn(BinaryOp op, Operand left, Operand right) {
  const Shape shape = left.shape;
  const bool is_product = shape.kind == Shape::kMatrix && op == BinaryOp::kMul;
  const bool is_vector_comparison = IsComparison(op) && shape.IsVector();
  if (is_vector_comparison || (is_product && !left.scalar && !right.scalar)) {
    const Operand operands[] = {std::move(left), std::move(right)};
    return CallOn(is_product ? "matrixCompMult" : OperatorOf(op).vector_function, operands);
  }
  const bool is_full = left.scalar && !shape.IsScalar() && (right.scalar || IsShift(op));
  Text first = is_full ? Full(left) : ScalarOr(std::move(left));
  return Infix(std::move(first), OperatorOf(op).spelling, ScalarOr(std::move(right)),
               OperatorOf(op).binding);
}

Text Writer::ConvertOn(Scalar kind, const Operand& operand) {
  const Shape to = operand.shape.With(kind);
  if (TypeName(to) == TypeName(operand.shape)) return Full(operand);
  if (operand.scalar && !operand.shape.HasRows()) {
    return {TypeName(to) + "(" + Argument(*operand.scalar) + ")"};
  }
  return {TypeName(to) + "(" + Argument(Full(operand)) + ")"};
}

}  // namespace clipc::glsl
