// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/buffer_call.h"

#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/object_call.h"
#include "backend-glsl/writer/objects.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The elements of a buffer, which may be one of an array of buffers.
std::string ElementsOf(Code& code, ExprId object) {
  return Concat(code.NameOf(RootOf(code.program, object)), IndexPath(code, object),
                code.As<Index>(object) ? ".elements" : "");
}

// The path ".lists[i].xy" that steps lead to in an element of a structured buffer; `count` is the
// number of components of what is there.
std::string PathAlong(Code& code, TypeId id, std::span<const ExprId> steps, std::size_t count) {
  std::string path;
  bool is_row = false;  // whether the last step was one to a row of a matrix
  for (const ExprId step : steps) {
    const Type& type = code[id];
    const auto* number = code.As<Literal>(step);
    if (type.kind == TypeKind::kStruct) {
      const std::uint32_t field = UintOf(number->bits);
      Append(path, ".", code.FieldsOf(type.structure)[field]);
      id = code.types.StructOf(id).fields[field].type;
      continue;
    }
    const bool is_array = type.kind == TypeKind::kArray;
    const bool is_matrix = type.kind == TypeKind::kMatrix && !is_row;
    const bool has_rows = type.rows > 1 && type.columns > 1;
    if (is_array || (is_matrix && has_rows) || (!number && type.Components() > 1) ||
        (is_row && has_rows && count == 1)) {
      Append(path, "[", IndexValue(code, step), "]");
    } else if (const std::size_t all = is_matrix ? type.rows : type.columns;
               all > 1 && count < all) {
      Append(path, ".", std::string_view("xyzw").substr(UintOf(number->bits), count));
    }
    if (is_array) id = type.element;
    is_row = is_matrix;
  }
  return path;
}

}  // namespace

Text StructuredLoad(Code& code, const ObjectCall& node) {
  const ExprId object = code.Operand(node, OperandKind::kObject);
  const ExprId place = code.Operand(node, OperandKind::kPlace);
  return {Concat(ElementsOf(code, object), "[", IndexValue(code, place), "]")};
}

Text BufferStore(Code& code, const ObjectCall& node) {
  const std::string value = Argument(code, code.Operand(node, OperandKind::kValue));
  return {Concat(BufferWord(code, node), " = ", value), Binding::kAssignment};
}

std::string BufferWord(Code& code, const ObjectCall& node) {
  const ExprId object = code.Operand(node, OperandKind::kObject);
  const ExprId place = code.Operand(node, OperandKind::kPlace);
  const ExprId value = code.Operand(node, OperandKind::kValue);
  const std::string element = Concat(ElementsOf(code, object), "[", IndexValue(code, place), "]");
  const auto steps = code[OperandsOf(node, OperandKind::kStep)];
  if (steps.empty()) return element;
  const std::size_t count = code.TypeOf(value).Components();
  return element +
         PathAlong(code, ObjectTypeOf(code, RootOf(code.program, object)).element, steps, count);
}

Text BufferSize(Code& code, ExprId object) { return {ElementsOf(code, object) + ".length()"}; }

}  // namespace clipc::glsl
