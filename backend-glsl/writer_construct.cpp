// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Constructors: Construct, MatrixTruncate.
#include <variant>

#include "backend-glsl/literal.h"
#include "backend-glsl/writer.h"
#include "base/invariant.h"

namespace clipc::glsl {

using namespace ir;

Text Writer::ConstructText(const ir::Expr& expr, const Construct& node) {
  const Type& type = program_.types[expr.type];
  const auto arguments = program_.expr_lists[node.arguments];
  if (type.IsNumeric()) return NumericConstruct(ShapeOf(type), arguments);
  std::string text = TypeName(expr.type) + "(";
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (i > 0) text += ", ";
    if (type.kind == TypeKind::kArray) {
      text += ElementText(type.element, Expr(arguments[i]));
    } else {
      text += ArgumentOf(arguments[i]);
    }
  }
  if (arguments.empty() && type.kind == TypeKind::kStruct)
    text += "0.0";  // the field that stands in for none
  return {text + ")"};
}

Text Writer::NumericConstruct(const Shape& shape, std::span<const ExprId> arguments) {
  if (arguments.size() == 1 && ShapeAt(arguments[0]) == shape) return Expr(arguments[0]);
  const auto* first = std::get_if<Literal>(&program_.exprs[arguments[0]].node);
  bool all_equal = first && shape.IsVector();
  for (ExprId argument : arguments) {
    const auto* literal = std::get_if<Literal>(&program_.exprs[argument].node);
    if (!literal || !all_equal || literal->bits != first->bits) all_equal = false;
  }
  if (all_equal) return SplatText(Expr(arguments[0]), shape, true);

  const bool rows_of_scalars = shape.kind == Shape::kRows && ShapeAt(arguments[0]).IsScalar();
  std::string text = TypeName(shape) + "(";
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (i > 0) text += ", ";
    if (rows_of_scalars && i % shape.size == 0) text += TypeName(shape.Row()) + "(";
    text += ArgumentOf(arguments[i]);
    if (rows_of_scalars && (i + 1) % shape.size == 0) text += ")";
  }
  return {text + ")"};
}

Text Writer::MatrixTruncateText(const ir::Expr& expr, const MatrixTruncate& node) {
  const Type& type = program_.types[expr.type];
  const Shape from = ShapeAt(node.operand), to = ShapeOf(type);
  Text operand = Expr(node.operand);
  if (from == to) return operand;
  const std::string components = std::string(".xyzw").substr(0, to.size + 1u);
  if (!from.HasRows()) return {std::move(operand).At(Binding::kPostfix) + components};
  if (to.kind == Shape::kMatrix) {
    return {TypeName(to) + "(" + Argument(std::move(operand)) + ")"};
  }
  if (type.rows == 1) {
    return {std::move(operand).At(Binding::kPostfix) + "[0]" +
            (to.size == from.size ? "" : components)};
  }
  const bool whole = to.size == from.rows;
  return {"transpose(" + Argument(std::move(operand)) + ")[0]" + (whole ? "" : components)};
}

}  // namespace clipc::glsl
