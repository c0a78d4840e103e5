// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "ir/program.h"
#include "legalize/needs.h"

namespace clipc::legalize {

// The counterpart of a numeric HLSL type in languages like GLSL, which have vectors from two
// components on and matrices of floats. float1 is a scalar; a matrix of one row or one column is a
// vector; other float and double matrices are matrices whose column i is HLSL's row i; matrices of
// other kinds are arrays of their rows, as are matrices that are not square where the target lacks
// those.
struct Shape {
  enum Kind : std::uint8_t { kScalar, kVector, kMatrix, kRows };
  Kind kind = kScalar;
  ir::Scalar scalar = ir::Scalar::kFloat;  // one of BaseOf's
  std::uint8_t rows = 1;                   // kMatrix, kRows: HLSL's rows
  std::uint8_t size = 1;                   // components of a vector or of a row

  bool IsScalar() const { return kind == kScalar; }
  bool IsVector() const { return kind == kVector; }
  bool HasRows() const { return kind == kMatrix || kind == kRows; }
  bool IsFloating() const { return scalar == ir::Scalar::kFloat || scalar == ir::Scalar::kDouble; }
  Shape Row() const { return {size == 1 ? kScalar : kVector, scalar, 1, size}; }
  Shape Component() const { return {kScalar, scalar, 1, 1}; }
  // Returns this shape with the component kind `kind`: a comparison of two float4x4 is four rows of
  // bool4.
  Shape With(ir::Scalar kind) const;
  friend bool operator==(const Shape&, const Shape&) = default;
};

// Returns the shape of `type`, which must be numeric.
Shape ShapeOf(const ir::Type& type, const Needs& needs);
Shape ShapeOf(ir::Scalar scalar, int rows, int columns);

// Whether the only row of a matrix or the only component is indexed, which cannot be indexed.
bool IsOnlyElement(const ir::Program& program, const ir::Index& node);

// The word for a shape that is not in rows, in GLSL and in the names of helper functions: "vec3",
// "dmat4x3". Where the target has no uint, uint is int.
std::string_view WordOf(const Shape& shape, bool has_unsigned);

// The name of a shape: its word, or the array "bvec4[3]".
std::string NameOf(const Shape& shape, bool has_unsigned = true);

}  // namespace clipc::legalize
