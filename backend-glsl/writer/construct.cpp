// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/construct.h"

#include <algorithm>

#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/operand.h"
#include "backend-glsl/writer/types.h"

namespace clipc::glsl {

using namespace ir;

namespace {

Text NumericConstruct(Code& code, const Shape& shape, std::span<const ExprId> arguments) {
  const ExprId first = arguments[0];
  const Shape first_shape = code.ShapeAt(first);
  if (arguments.size() == 1 && first_shape == shape) return ExprText(code, first);
  const bool all_equal = shape.IsVector() && std::ranges::all_of(arguments, [&](ExprId id) {
                           const auto* literal = code.As<Literal>(id);
                           const auto* other = code.As<Literal>(first);
                           return literal && other && literal->bits == other->bits;
                         });
  if (all_equal) return SplatText(code, ExprText(code, first), shape, true);

  const auto argument = [&](ExprId id) { return Argument(code, id); };
  const std::string type = TypeName(code, shape);
  if (shape.kind != Shape::kRows || !first_shape.IsScalar()) {
    return Called(type, {ListOf(arguments, argument)});
  }
  const auto row = [&](std::size_t i) {
    return Called(TypeName(code, shape.Row()),
                  {ListOf(arguments.subspan(i * shape.size, shape.size), argument)})
        .text;
  };
  return Called(type, {ListOf(arguments.size() / shape.size, row)});
}

}  // namespace

Text ConstructText(Code& code, TypeId id, std::span<const ExprId> arguments) {
  const Type& type = code[id];
  if (type.IsNumeric()) return NumericConstruct(code, ShapeOf(type, code.target), arguments);
  const std::string name = TypeName(code, id);
  const std::string list = ListOf(arguments, [&](ExprId argument) {
    return type.kind == TypeKind::kArray ? ElementText(code, type.element, ExprText(code, argument))
                                         : Argument(code, argument);
  });
  // A struct without fields has one float in GLSL, which requires a field.
  const bool is_empty = arguments.empty() && type.kind == TypeKind::kStruct;
  return Called(name, {is_empty ? "0.0" : list});
}

Text TruncateText(Code& code, TypeId id, ExprId matrix) {
  const Type& type = code[id];
  const Shape from = code.ShapeAt(matrix), to = ShapeOf(type, code.target);
  Text operand = ExprText(code, matrix);
  if (from == to) return operand;
  const std::string_view components = std::string_view(".xyzw").substr(0, to.size + 1u);
  if (to.kind == Shape::kMatrix) {
    return Called(TypeName(code, to), {Argument(std::move(operand))});
  }
  // The result is the first row, or the first column, which is the first row of the transpose.
  const bool is_row = type.rows == 1;
  std::string text = from.HasRows() && !is_row
                         ? Called("transpose", {Argument(std::move(operand))}).text
                         : std::move(operand).At(Binding::kPostfix);
  const bool is_whole = from.HasRows() && to.size == (is_row ? from.size : from.rows);
  Append(text, from.HasRows() ? "[0]" : "", is_whole ? "" : components);
  return {std::move(text)};
}

}  // namespace clipc::glsl
