// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/matrix.h"

#include <cmath>
#include <cstddef>

#include "runtime/double_double.h"

namespace clipc::runtime {
namespace {

template <typename Number>
Matrix FromElements(const Number (&elements)[16]) {
  Matrix matrix;
  for (std::size_t i = 0; i < 16; ++i) matrix.m[i / 4][i % 4] = static_cast<double>(elements[i]);
  return matrix;
}

// a . b as if computed in twice double's precision and rounded once: Dot2 of Ogita, Rump and Oishi,
// "Accurate Sum and Dot Product".
double CompensatedDot(const double (&a)[4], const Plane& plane) {
  const double b[4] = {plane.x, plane.y, plane.z, plane.w};
  double sum = a[0] * b[0];
  double error = ProductError(a[0], b[0], sum);
  for (int i = 1; i < 4; ++i) {
    const double product = a[i] * b[i];
    const double next = sum + product;
    const double part = next - sum;
    error += ProductError(a[i], b[i], product) + ((sum - (next - part)) + (product - part));
    sum = next;
  }
  // Infinite and NaN sums keep their meaning.
  return std::isfinite(error) ? sum + error : sum;
}

}  // namespace

Matrix RowVectorMatrix(const float (&elements)[16]) noexcept { return FromElements(elements); }
Matrix RowVectorMatrix(const double (&elements)[16]) noexcept { return FromElements(elements); }
Matrix ColumnVectorMatrix(const float (&elements)[16]) noexcept {
  return Transpose(FromElements(elements));
}
Matrix ColumnVectorMatrix(const double (&elements)[16]) noexcept {
  return Transpose(FromElements(elements));
}

Matrix Multiply(const Matrix& first, const Matrix& second) noexcept {
  Matrix product;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) sum += first.m[row][k] * second.m[k][column];
      product.m[row][column] = sum;
    }
  }
  return product;
}

Matrix Transpose(const Matrix& matrix) noexcept {
  Matrix transposed;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) transposed.m[row][column] = matrix.m[column][row];
  }
  return transposed;
}

double Dot(const Plane& plane, const double (&point)[4]) noexcept {
  return plane.x * point[0] + plane.y * point[1] + plane.z * point[2] + plane.w * point[3];
}

Plane PlaneBefore(const Matrix& matrix, const Plane& after) noexcept {
  return {CompensatedDot(matrix.m[0], after), CompensatedDot(matrix.m[1], after),
          CompensatedDot(matrix.m[2], after), CompensatedDot(matrix.m[3], after)};
}

double NormalLength(const Plane& plane) noexcept { return std::hypot(plane.x, plane.y, plane.z); }

}  // namespace clipc::runtime
