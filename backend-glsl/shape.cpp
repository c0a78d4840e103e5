// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/shape.h"

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/object.h"

namespace clipc::glsl {

using ir::Scalar;

namespace {

// The prefix of a vector type: "b" of bvec3, "" of vec3.
const char* VectorPrefix(Scalar scalar, bool has_unsigned) {
  switch (scalar) {
    case Scalar::kBool: return "b";
    case Scalar::kInt: return "i";
    case Scalar::kUint: return has_unsigned ? "u" : "i";
    case Scalar::kDouble: return "d";
    case Scalar::kInt64: return "i64";
    case Scalar::kUint64: return "u64";
    default: return "";
  }
}

}  // namespace

Shape ShapeOf(Scalar scalar, int rows, int columns) {
  Shape shape{.scalar = ir::BaseOf(scalar)};
  const bool is_matrix = rows > 1 && columns > 1;
  shape.rows = static_cast<std::uint8_t>(is_matrix ? rows : 1);
  shape.size = static_cast<std::uint8_t>(is_matrix ? columns : rows * columns);
  if (is_matrix) {
    shape.kind = shape.IsFloating() ? Shape::kMatrix : Shape::kRows;
  } else {
    shape.kind = shape.size == 1 ? Shape::kScalar : Shape::kVector;
  }
  return shape;
}

Shape ShapeOf(const ir::Type& type, const Target& target) {
  CLIPC_CHECK(type.IsNumeric());
  Shape shape = ShapeOf(type.scalar, type.rows, type.columns);
  const bool is_oblong = shape.kind == Shape::kMatrix && shape.rows != shape.size;
  if (is_oblong && !target.Has(Feature::kFullMatrices)) shape.kind = Shape::kRows;
  return shape;
}

bool IsOnlyElement(const ir::Program& program, const ir::Index& node) {
  const ir::Type& type = program.types[program.exprs[node.base].type];
  const bool is_only_row = type.kind == ir::TypeKind::kMatrix && type.rows == 1;
  return type.IsNumeric() && (is_only_row || type.Components() == 1);
}

Shape Shape::With(Scalar kind) const {
  Shape shape = ShapeOf(kind, rows, size);
  if (this->kind == kRows && IsFloating()) shape.kind = kRows;
  return shape;
}

std::string GlslName(Scalar scalar, bool has_unsigned) {
  switch (ir::BaseOf(scalar)) {
    case Scalar::kBool: return "bool";
    case Scalar::kInt: return "int";
    case Scalar::kUint: return has_unsigned ? "uint" : "int";
    case Scalar::kDouble: return "double";
    case Scalar::kInt64: return "int64_t";
    case Scalar::kUint64: return "uint64_t";
    default: return "float";
  }
}

std::string GlslName(const Shape& shape, bool has_unsigned) {
  if (shape.IsScalar()) return GlslName(shape.scalar, has_unsigned);
  const auto digit = [](std::uint8_t size) { return static_cast<char>('0' + size); };
  std::string name = VectorPrefix(shape.scalar, has_unsigned);
  name += shape.kind == Shape::kMatrix ? "mat" : "vec";
  name += digit(shape.kind == Shape::kMatrix ? shape.rows : shape.size);
  if (shape.kind == Shape::kMatrix && shape.rows != shape.size) {
    name += 'x';
    name += digit(shape.size);
  }
  if (shape.kind == Shape::kRows) {
    name += '[';
    name += digit(shape.rows);
    name += ']';
  }
  return name;
}

SamplerElement SamplerElementAt(const ir::Program& program, ir::ExprId expr) {
  const auto* index = ir::As<ir::Index>(program, expr);
  const auto* array = index ? ir::As<ir::VarRef>(program, index->base) : nullptr;
  const auto* number = index ? ir::As<ir::Literal>(program, index->index) : nullptr;
  const ir::Type& type = ir::TypeOf(program, expr);
  const bool is_sampler = type.kind == ir::TypeKind::kObject &&
                          ir::InfoOf(type.object).category == ir::ObjectCategory::kSampler;
  if (!array || !number || !is_sampler) return {};
  // A parameter stands in functions that are called with objects of the shader in its place.
  if (program.vars[array->var].storage != ir::Storage::kResource) return {};
  return {array->var, static_cast<std::uint32_t>(number->bits)};
}

}  // namespace clipc::glsl
