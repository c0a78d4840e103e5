// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/operand.h"

#include <optional>

#include <fmt/format.h>

#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/helper.h"
#include "backend-glsl/writer/types.h"
#include "legalize/constant.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// A matrix with `scalar`, an argument of a call, in every component.
std::string MatrixOf(Code& code, const Shape& shape, std::string_view scalar) {
  const std::string row = Concat(TypeName(code, shape.Row()), "(", scalar, ")");
  return Called(TypeName(code, shape), {ListOf(int{shape.rows}, [&](int) { return row; })}).text;
}

Binding WriteMatrixSplat(Code& code, const Shape& shape, ExprId scalar) {
  const std::string argument = Argument(code, scalar), type = TypeName(code, shape);
  if (IsRepeatable(code.program, scalar)) {
    // mat4(x) is x on the diagonal only.
    const std::optional<legalize::Constant> number = legalize::ConstantOf(code.program, scalar);
    const bool is_zero = shape.kind == Shape::kMatrix && number && number->bits == 0;
    code.Put(is_zero ? Concat(type, "(", argument, ")") : MatrixOf(code, shape, argument));
    return Binding::kPostfix;
  }
  const std::string component = TypeName(code, shape.Component());
  const std::string name = Helper(code, "splat_" + type, component, [&](const std::string& helper) {
    return fmt::format("{} {}({} x) {{\n    return {};\n}}\n", type, helper, component,
                       MatrixOf(code, shape, "x"));
  });
  code.Put(name, "(", argument, ")");
  return Binding::kPostfix;
}

}  // namespace

Binding WriteOperand(Code& code, ExprId operand) {
  if (code.As<Zero>(operand)) {
    code.Put(ZeroText(code, code.ShapeAt(operand).Component()));
    return Binding::kPostfix;
  }
  const auto* splat = code.As<Splat>(operand);
  return WriteExpr(code, splat ? splat->operand : operand);
}

void WriteOperandAt(Code& code, ExprId operand, Binding least) {
  const std::size_t begin = code.out->size();
  if (WriteOperand(code, operand) < least) code.EncloseFrom(begin);
}

Binding WriteSplat(Code& code, const Shape& shape, ExprId scalar) {
  if (shape.IsScalar()) return WriteExpr(code, scalar);
  if (!shape.IsVector()) return WriteMatrixSplat(code, shape, scalar);
  code.Put(TypeName(code, shape), "(");
  WriteAt(code, scalar, Binding::kAssignment);
  code.Put(")");
  return Binding::kPostfix;
}

Binding WriteOperator(Code& code, UnaryOp op, ExprId operand) {
  if (op == UnaryOp::kNot && code.ShapeAt(operand).IsVector())
    return WriteCall(code, "not", {&operand, 1});
  const bool is_minus = op == UnaryOp::kNegate;
  code.Put(is_minus ? "-" : op == UnaryOp::kNot ? "!" : "~");
  WriteAt(code, operand, is_minus ? Binding::kUnary : Binding::kMinus);
  return is_minus ? Binding::kMinus : Binding::kUnary;
}

// A scalar operand may be left a scalar beside a vector or matrix, but for the left one of a shift.
// GLSL's operators associate to the left.
Binding WriteOperator(Code& code, BinaryOp op, ExprId left, ExprId right) {
  const Shape shape = code.ShapeAt(left);
  const Operator& glsl = OperatorOf(op);
  const bool left_is_scalar = IsOneScalar(code.program, left);
  const bool right_is_scalar = IsOneScalar(code.program, right);
  const bool is_product = shape.kind == Shape::kMatrix && op == BinaryOp::kMul;
  const bool is_vector_comparison = IsComparison(op) && shape.IsVector();
  if (is_vector_comparison || (is_product && !left_is_scalar && !right_is_scalar)) {
    const ExprId operands[] = {left, right};
    return WriteCall(code, is_product ? "matrixCompMult" : glsl.vector_function, operands);
  }
  // Few people know that shifts bind tighter than &, and less tightly than +.
  const bool is_of_bits = IsShift(op) || IsBitwise(op);
  const auto* inner = code.As<Binary>(left);
  const Binding least = is_of_bits && !(inner && inner->op == op) ? Binding::kMinus : glsl.binding;
  if (left_is_scalar && !shape.IsScalar() && (right_is_scalar || IsShift(op)))
    WriteAt(code, left, least);
  else
    WriteOperandAt(code, left, least);
  code.Put(" ", SpellingOf(op), " ");
  WriteOperandAt(code, right, is_of_bits ? Binding::kMinus : Tighter(glsl.binding));
  return glsl.binding;
}

Binding WriteConverted(Code& code, Scalar kind, ExprId operand) {
  const Shape from = code.ShapeAt(operand);
  const std::string type = TypeName(code, from.With(kind));
  if (type == TypeName(code, from)) return WriteExpr(code, operand);
  code.Put(type, "(");
  if (from.HasRows())
    WriteAt(code, operand, Binding::kAssignment);
  else
    WriteOperandAt(code, operand, Binding::kAssignment);
  code.Put(")");
  return Binding::kPostfix;
}

Binding WriteCall(Code& code, std::string_view function, std::span<const ExprId> arguments,
                  unsigned scalars) {
  bool all_scalar = scalars != 0;
  for (std::size_t i = 0; all_scalar && i < arguments.size(); ++i)
    all_scalar = IsOneScalar(code.program, arguments[i]) == ((scalars >> i & 1) != 0);
  code.Put(function, "(");
  if (all_scalar) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (i > 0) code.Put(", ");
      WriteOperandAt(code, arguments[i], Binding::kAssignment);
    }
  } else {
    WriteArguments(code, arguments);
  }
  code.Put(")");
  return Binding::kPostfix;
}

}  // namespace clipc::glsl
