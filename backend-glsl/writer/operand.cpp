// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/operand.h"

#include <fmt/format.h>

#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/helper.h"
#include "backend-glsl/writer/types.h"
#include "base/overloaded.h"

namespace clipc::glsl {

using namespace ir;

namespace {

bool IsRepeatable(const Program& program, ExprId id) {
  const auto* index = As<Index>(program, id);
  if (index && !As<Literal>(program, index->index)) return false;
  if (As<MatrixSwizzle>(program, id)) return false;
  const ExprId whole = WholeOf(program, id);
  return whole ? IsRepeatable(program, whole) : As<Literal>(program, id) || As<VarRef>(program, id);
}

}  // namespace

Operand OperandOf(Code& code, ExprId id) {
  Operand operand{{}, code.ShapeAt(id), {}, ConstantOf(code.program, id)};
  const auto* splat = code.As<Splat>(id);
  if (code.As<Zero>(id)) {
    operand.repeatable = true;
    operand.scalar = Text{ZeroText(code, operand.shape.Component())};
    return operand;
  }
  const ExprId written = splat ? splat->operand : id;
  operand.repeatable = IsRepeatable(code.program, written);
  Text text = ExprText(code, written);
  if (splat || code.As<Literal>(id)) {
    operand.scalar = std::move(text);
  } else {
    operand.text = std::move(text);
  }
  return operand;
}

std::vector<Operand> OperandsOf(Code& code, List<ExprId> list) {
  std::vector<Operand> operands;
  operands.reserve(list.size);
  for (const ExprId id : code[list]) operands.push_back(OperandOf(code, id));
  return operands;
}

Text Full(Code& code, const Operand& operand) {
  if (!operand.scalar) return operand.text;
  return SplatText(code, *operand.scalar, operand.shape, operand.repeatable,
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

// A scalar operand may stand beside a vector or matrix as it is, but for the left one of a shift.
Text BinaryOn(Code& code, BinaryOp op, Operand left, Operand right) {
  const Shape shape = left.shape;
  const Operator& glsl = OperatorOf(op);
  const bool is_product = shape.kind == Shape::kMatrix && op == BinaryOp::kMul;
  const bool is_vector_comparison = IsComparison(op) && shape.IsVector();
  if (is_vector_comparison || (is_product && !left.scalar && !right.scalar)) {
    const Operand operands[] = {std::move(left), std::move(right)};
    return CallOn(code, is_product ? "matrixCompMult" : glsl.vector_function, operands);
  }
  const bool is_full = left.scalar && !shape.IsScalar() && (right.scalar || IsShift(op));
  Text first = is_full ? Full(code, left) : ScalarOr(std::move(left));
  return Infix(std::move(first), glsl.spelling, ScalarOr(std::move(right)), glsl.binding);
}

Text ConvertOn(Code& code, Scalar kind, const Operand& operand) {
  const Shape& from = operand.shape;
  const std::string type = TypeName(code, from.With(kind));
  if (type == TypeName(code, from)) return Full(code, operand);
  const bool is_scalar = operand.scalar && !from.HasRows();
  return Called(type, {Argument(is_scalar ? *operand.scalar : Full(code, operand))});
}

Text CallOn(Code& code, std::string_view function, std::span<const Operand> operands,
            unsigned scalars) {
  bool all_scalar = scalars != 0;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (operands[i].scalar.has_value() != ((scalars >> i & 1) != 0)) all_scalar = false;
  }
  std::string text;
  text.reserve(64);
  Append(text, function, "(");
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const Operand& operand = operands[i];
    Append(text, i > 0 ? ", " : "",
           Argument(all_scalar && operand.scalar ? *operand.scalar : Full(code, operand)));
  }
  text += ')';
  return {std::move(text)};
}

Text SnippetCall(Code& code, std::string_view name, std::span<const Operand> operands) {
  return CallOn(code, SnippetName(code, name, operands[0].shape), operands);
}

}  // namespace clipc::glsl
