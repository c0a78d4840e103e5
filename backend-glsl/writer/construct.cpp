// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/construct.h"

#include <algorithm>

#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/operand.h"
#include "backend-glsl/writer/types.h"

namespace clipc::glsl {

using namespace ir;

namespace {

Binding WriteNumeric(Code& code, const Shape& shape, std::span<const ExprId> arguments) {
  const ExprId first = arguments[0];
  const Shape first_shape = code.ShapeAt(first);
  if (arguments.size() == 1 && first_shape == shape) return WriteExpr(code, first);
  const bool all_equal = shape.IsVector() && std::ranges::all_of(arguments, [&](ExprId id) {
                           const auto* literal = code.As<Literal>(id);
                           const auto* other = code.As<Literal>(first);
                           return literal && other && literal->bits == other->bits;
                         });
  if (all_equal) return WriteSplat(code, shape, first);

  code.Put(TypeName(code, shape), "(");
  if (shape.kind != Shape::kRows || !first_shape.IsScalar()) {
    WriteArguments(code, arguments);
  } else {
    for (std::size_t i = 0; i < arguments.size(); i += shape.size) {
      code.Put(i > 0 ? ", " : "", TypeName(code, shape.Row()), "(");
      WriteArguments(code, arguments.subspan(i, shape.size));
      code.Put(")");
    }
  }
  code.Put(")");
  return Binding::kPostfix;
}

}  // namespace

Binding WriteConstruct(Code& code, TypeId id, std::span<const ExprId> arguments) {
  const Type& type = code[id];
  if (type.IsNumeric()) return WriteNumeric(code, ShapeOf(type, code.needs), arguments);
  code.Put(TypeName(code, id), "(");
  if (type.kind == TypeKind::kArray) {
    code.Put(ListOf(arguments, [&](ExprId argument) {
      return ElementText(code, type.element, ExprText(code, argument));
    }));
  } else {
    WriteArguments(code, arguments);
  }
  // A struct without fields has one float in GLSL, which requires a field.
  if (arguments.empty() && type.kind == TypeKind::kStruct) code.Put("0.0");
  code.Put(")");
  return Binding::kPostfix;
}

Binding WriteTruncated(Code& code, const Type& type, ExprId matrix) {
  const Shape from = code.ShapeAt(matrix), to = ShapeOf(type, code.needs);
  if (from == to) return WriteExpr(code, matrix);
  // The result is the first row, or the first column, which is the first row of the transpose.
  const bool is_row = type.rows == 1, is_column = from.HasRows() && !is_row;
  const bool is_matrix = to.kind == Shape::kMatrix;
  if (is_matrix || is_column) {
    code.Put(is_matrix ? TypeName(code, to) : "transpose", "(");
    WriteAt(code, matrix, Binding::kAssignment);
    code.Put(")");
  } else {
    WriteAt(code, matrix, Binding::kPostfix);
  }
  if (is_matrix) return Binding::kPostfix;
  const bool is_whole = from.HasRows() && to.size == (is_row ? from.size : from.rows);
  code.Put(from.HasRows() ? "[0]" : "",
           is_whole ? "" : std::string_view(".xyzw").substr(0, to.size + 1u));
  return Binding::kPostfix;
}

}  // namespace clipc::glsl
