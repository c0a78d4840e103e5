// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/operand.h"

#include <fmt/format.h>

#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/helper.h"
#include "backend-glsl/writer/types.h"
#include "base/overloaded.h"

namespace clipc::glsl {

using namespace ir;

Operand OperandOf(Code& code, ExprId id) {
  const Shape shape = code.ShapeAt(id);
  const std::optional<Constant> constant = ConstantOf(code.program, id);
  if (code.As<Zero>(id)) return {{ZeroText(code, shape.Component())}, shape, true, constant, true};
  const auto* splat = code.As<Splat>(id);
  const ExprId written = splat ? splat->operand : id;
  const bool is_scalar = IsOneScalar(code.program, id);
  return {ExprText(code, written), shape, is_scalar, constant,
          (is_scalar || shape.IsScalar()) && IsRepeatable(code.program, written)};
}

std::vector<Operand> OperandsOf(Code& code, List<ExprId> list) {
  std::vector<Operand> operands;
  operands.reserve(list.size);
  for (const ExprId id : code[list]) operands.push_back(OperandOf(code, id));
  return operands;
}

Text Full(Code& code, Operand operand) {
  if (!operand.is_scalar) return std::move(operand.text);
  return SplatText(code, operand.text, operand.shape, operand.repeatable,
                   operand.constant && operand.constant->bits == 0);
}

Text SplatText(Code& code, const Text& scalar, const Shape& shape, bool repeatable, bool is_zero) {
  if (shape.IsScalar()) return scalar;
  const std::string type = TypeName(code, shape);
  if (shape.IsVector()) return Called(type, {Argument(scalar)});
  if (!repeatable) {
    const std::string component = TypeName(code, shape.Component());
    const std::string name =
        Helper(code, "splat_" + type, component, [&](const std::string& helper) {
          return fmt::format("{} {}({} x) {{\n    return {};\n}}\n", type, helper, component,
                             SplatText(code, {"x"}, shape, true).text);
        });
    return Called(name, {Argument(scalar)});
  }
  // mat4(x) is x on the diagonal only.
  if (shape.kind == Shape::kMatrix && is_zero) return Called(type, {scalar.text});
  const auto row = [&](int) { return SplatText(code, scalar, shape.Row(), true).text; };
  return Called(type, {ListOf(int{shape.rows}, row)});
}

Text UnaryOn(Code& code, UnaryOp op, const Operand& operand) {
  if (op == UnaryOp::kNot && operand.shape.IsVector()) return CallOn(code, "not", {&operand, 1});
  const bool is_minus = op == UnaryOp::kNegate;
  const char* spelling = is_minus ? "-" : op == UnaryOp::kNot ? "!" : "~";
  return {spelling + Full(code, operand).At(is_minus ? Binding::kUnary : Binding::kMinus),
          is_minus ? Binding::kMinus : Binding::kUnary};
}

// A scalar operand may be left a scalar beside a vector or matrix, but for the left one of a shift.
Text BinaryOn(Code& code, BinaryOp op, Operand left, Operand right) {
  const Shape shape = left.shape;
  const Operator& glsl = OperatorOf(op);
  const bool is_product = shape.kind == Shape::kMatrix && op == BinaryOp::kMul;
  const bool is_vector_comparison = IsComparison(op) && shape.IsVector();
  if (is_vector_comparison || (is_product && !left.is_scalar && !right.is_scalar)) {
    const Operand operands[] = {std::move(left), std::move(right)};
    return CallOn(code, is_product ? "matrixCompMult" : glsl.vector_function, operands);
  }
  const bool is_full = left.is_scalar && !shape.IsScalar() && (right.is_scalar || IsShift(op));
  return Infix(is_full ? Full(code, std::move(left)) : std::move(left.text), glsl.spelling,
               right.text, glsl.binding);
}

Text ConvertOn(Code& code, Scalar kind, const Operand& operand) {
  const Shape& from = operand.shape;
  const std::string type = TypeName(code, from.With(kind));
  if (type == TypeName(code, from)) return Full(code, operand);
  const bool is_scalar = operand.is_scalar && !from.HasRows();
  return Called(type, {Argument(is_scalar ? operand.text : Full(code, operand))});
}

Text CallOn(Code& code, std::string_view function, std::span<const Operand> operands,
            unsigned scalars) {
  bool all_scalar = scalars != 0;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (operands[i].is_scalar != ((scalars >> i & 1) != 0)) all_scalar = false;
  }
  std::string text;
  text.reserve(64);
  Append(text, function, "(");
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const Operand& operand = operands[i];
    if (i > 0) text += ", ";
    if (all_scalar || !operand.is_scalar)
      operand.text.AppendTo(text, Binding::kAssignment);
    else
      Full(code, operand).AppendTo(text, Binding::kAssignment);
  }
  text += ')';
  return {std::move(text)};
}

Text SnippetCall(Code& code, std::string_view name, std::span<const Operand> operands) {
  return CallOn(code, SnippetName(code, name, operands[0].shape), operands);
}

}  // namespace clipc::glsl
