// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception mul() and matrices. GLSL's matrices are
// the transposes of HLSL's, so products turn round: mul(v, M) is M * v.
#include <utility>

#include "backend-glsl/writer_state.h"

namespace clipc::glsl {

using namespace ir;

Text Writer::MulText(ExprId left, ExprId right, const Type& result_type) {
  const Type& left_type = TypeOf(left);
  const Type& right_type = TypeOf(right);
  const Shape l = ShapeOf(left_type), r = ShapeOf(right_type), result = ShapeOf(result_type);
  // A vector is a row on the left and a column on the right.
  const bool left_is_column = left_type.kind == TypeKind::kMatrix && left_type.columns == 1;

  if (l.IsScalar() || r.IsScalar()) {
    // Of a scalar with anything, or of float1x1 with a row: the scalar stands for all components.
    Operand a = OperandOf(left), b = OperandOf(right);
    const auto widen = [&](Operand& operand) {
      if (!operand.shape.IsScalar() || result.IsScalar()) return;
      operand.scalar = Full(operand);
      operand.shape = result;
    };
    if (!(l.IsScalar() && r.IsScalar())) widen(l.IsScalar() ? a : b);
    return BinaryOn(BinaryOp::kMul, a, b, true);
  }
  if (l.IsVector() && r.IsVector()) {
    if (left_is_column && !l.IsFloating()) return RowsMulText(left, right, result);
    const Operand a = OperandOf(left), b = OperandOf(right);
    if (!left_is_column) return DotOn(a, b);
    return {"outerProduct(" + Argument(Full(b)) + ", " + Argument(Full(a)) + ")"};
  }
  if (l.kind == Shape::kRows || r.kind == Shape::kRows) return RowsMulText(left, right, result);
  Text first = Expr(left);
  return Infix(Expr(right), "*", std::move(first), Binding::kProduct);
}

// Products with a matrix of ints.
Text Writer::RowsMulText(ExprId left, ExprId right, const Shape& result) {
  const Shape l = ShapeAt(left), r = ShapeAt(right);
  const Operand operands[] = {OperandOf(left), OperandOf(right)};
  // One row of the product: the combination of b's rows that a row of a names.
  const auto combination = [&](const std::string& row, int count) {
    std::string sum;
    for (int i = 0; i < count; ++i) {
      sum += (i > 0 ? " + " : "") + row + "." + "xyzw"[i] + " * b[" + std::to_string(i) + "]";
    }
    return sum;
  };
  const std::string name =
      Helper("mul", TypeName(l) + " " + TypeName(r), [&](const std::string& function) {
        std::string value;
        if (l.IsVector() && r.HasRows()) {
          value = combination("a", r.rows);
        } else {
          for (int i = 0; i < l.rows * (l.IsVector() ? l.size : 1); ++i) {
            const std::string row =
                l.IsVector() ? std::string("a.") + "xyzw"[i] : "a[" + std::to_string(i) + "]";
            if (i > 0) value += ", ";
            if (l.IsVector())
              value += row + " * b";
            else if (r.HasRows())
              value += combination(row, r.rows);
            else
              value +=
                  DotOn({{row}, l.Row(), std::nullopt, true}, {{"b"}, r, std::nullopt, true}).text;
          }
          value = TypeName(result) + "(" + value + ")";
        }
        return TypeName(result) + " " + function + "(" + Declaration(l, "a") + ", " +
               Declaration(r, "b") + ") {\n    return " + value + ";\n}\n";
      });
  return CallOn(name, operands);
}

}  // namespace clipc::glsl
