// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

/// The types of the plane mathematics. Everything is computed in double; only inputs and results
/// are float.
///
/// The convention inside is Direct3D's: a point is a row vector and v' = v * M, so that clip = v *
/// World * View * Projection, and row 3 of an affine matrix is its translation. RowVectorMatrix and
/// ColumnVectorMatrix read matrices of either convention.
namespace clipc::runtime {

/// {A, B, C, D}: keeps the points (x, y, z, w) of its space with Ax + By + Cz + Dw >= 0. Any
/// positive multiple is the same plane; the zero plane keeps everything. The normal (A, B, C) may
/// have any length.
struct Plane {
  double x = 0, y = 0, z = 0, w = 0;
};

/// A plane or another constant as a shader or a device takes it: 16 bytes, to be copied to a
/// constant buffer as it is.
struct Float4 {
  float x = 0, y = 0, z = 0, w = 0;
};

/// m[row][column], applied to row vectors.
struct Matrix {
  double m[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
};

/// Sixteen numbers with the translation in elements 12, 13, 14: D3DMATRIX, DirectXMath's XMFLOAT4X4
/// (row-major, row vectors); OpenGL, glm and Vulkan samples (column-major, column vectors). The
/// bytes are the same.
Matrix RowVectorMatrix(const float (&elements)[16]) noexcept;
Matrix RowVectorMatrix(const double (&elements)[16]) noexcept;

/// Sixteen numbers with the translation in elements 3, 7, 11: matrices for column vectors written
/// row after row, as books print them; HLSL's `row_major` with mul(M, v).
Matrix ColumnVectorMatrix(const float (&elements)[16]) noexcept;
Matrix ColumnVectorMatrix(const double (&elements)[16]) noexcept;

/// first * second: first `first`, then `second`.
Matrix Multiply(const Matrix& first, const Matrix& second) noexcept;
Matrix Transpose(const Matrix& matrix) noexcept;

/// Ax + By + Cz + Dw. The value is a distance if the normal (A, B, C) is a unit vector, the space
/// has a metric (view, world or object space) and w = 1. In clip space only its sign has a meaning.
double Dot(const Plane& plane, const double (&point)[4]) noexcept;

/// The plane of the space *before* `matrix`, given the plane of the space after it:
/// before = matrix * after, so that Dot(before, v) == Dot(after, v * matrix) for every v. Needs no
/// inverse: with the world matrix it takes a world-space plane to object space. Each component is
/// one compensated dot product, which is right to double precision whatever cancels.
Plane PlaneBefore(const Matrix& matrix, const Plane& after) noexcept;

/// The length |(A, B, C)| of the plane's normal.
double NormalLength(const Plane& plane) noexcept;

}  // namespace clipc::runtime
