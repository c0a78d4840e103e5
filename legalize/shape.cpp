// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/shape.h"

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/object.h"

namespace clipc::legalize {

using ir::Scalar;

namespace {

// The names of the scalar, the vectors and the matrices of a kind; GLSL has matrices of two kinds.
struct KindNames {
  std::string_view scalar;
  std::string_view vectors[3];
  std::string_view matrices[3][3];  // by rows of HLSL and their size, from 2
};
const KindNames& NamesOf(Scalar scalar, bool has_unsigned) {
  static constexpr KindNames kFloats{
      "float",
      {"vec2", "vec3", "vec4"},
      {{"mat2", "mat2x3", "mat2x4"}, {"mat3x2", "mat3", "mat3x4"}, {"mat4x2", "mat4x3", "mat4"}}};
  static constexpr KindNames kDoubles{"double",
                                      {"dvec2", "dvec3", "dvec4"},
                                      {{"dmat2", "dmat2x3", "dmat2x4"},
                                       {"dmat3x2", "dmat3", "dmat3x4"},
                                       {"dmat4x2", "dmat4x3", "dmat4"}}};
  static constexpr KindNames kBools{"bool", {"bvec2", "bvec3", "bvec4"}, {}};
  static constexpr KindNames kInts{"int", {"ivec2", "ivec3", "ivec4"}, {}};
  static constexpr KindNames kUints{"uint", {"uvec2", "uvec3", "uvec4"}, {}};
  static constexpr KindNames kInts64{"int64_t", {"i64vec2", "i64vec3", "i64vec4"}, {}};
  static constexpr KindNames kUints64{"uint64_t", {"u64vec2", "u64vec3", "u64vec4"}, {}};
  switch (ir::BaseOf(scalar)) {
    case Scalar::kBool: return kBools;
    case Scalar::kInt: return kInts;
    case Scalar::kUint: return has_unsigned ? kUints : kInts;
    case Scalar::kDouble: return kDoubles;
    case Scalar::kInt64: return kInts64;
    case Scalar::kUint64: return kUints64;
    default: return kFloats;
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

Shape ShapeOf(const ir::Type& type, const Needs& needs) {
  CLIPC_CHECK(type.IsNumeric());
  Shape shape = ShapeOf(type.scalar, type.rows, type.columns);
  const bool is_oblong = shape.kind == Shape::kMatrix && shape.rows != shape.size;
  if (is_oblong && needs.square_matrices) shape.kind = Shape::kRows;
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

std::string_view WordOf(const Shape& shape, bool has_unsigned) {
  CLIPC_CHECK(shape.kind != Shape::kRows);
  const KindNames& names = NamesOf(shape.scalar, has_unsigned);
  if (shape.kind == Shape::kMatrix) return names.matrices[shape.rows - 2][shape.size - 2];
  return shape.size == 1 ? names.scalar : names.vectors[shape.size - 2];
}

std::string NameOf(const Shape& shape, bool has_unsigned) {
  if (shape.kind != Shape::kRows) return std::string(WordOf(shape, has_unsigned));
  std::string name(WordOf(shape.Row(), has_unsigned));
  (name += '[') += static_cast<char>('0' + shape.rows), name += ']';
  return name;
}

}  // namespace clipc::legalize
