// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/vertex_rounding.h"

namespace clipc::runtime::rounding {
namespace {

Vector4 Transform(const Vector4& v, const Matrix& m) {
  Vector4 to = {};
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) to.c[j] += v.c[i] * m.m[i][j];
  }
  return to;
}
// The slopes of a number by the coordinates before `m`, from its slopes by those after it.
Vector4 Before(const Matrix& m, const Vector4& slopes) {
  Vector4 before = {};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) before.c[i] += m.m[i][j] * slopes.c[j];
  }
  return before;
}
Vector4 RowOf(const Matrix& m, int i) { return {{m.m[i][0], m.m[i][1], m.m[i][2], m.m[i][3]}}; }

bool IsSameInFloat(const Matrix& m, int row) {
  return static_cast<float>(m.m[row][2]) == static_cast<float>(m.m[row][3]);
}

// The variance of slopes.c[2] * z + slopes.c[3] * w where z and w are rounded. Two numbers of one
// binade differ after rounding by one of the two multiples of its unit that are next to what they
// differ by.
double OfPair(double z, double w, const Vector4& slopes) {
  const double of_z = slopes.c[2] * slopes.c[2], of_w = slopes.c[3] * slopes.c[3];
  if (z == 0 || w == 0 || PowerOf(z) != PowerOf(w)) return of_z * Rounding(z) + of_w * Rounding(w);
  const double unit = PowerOf(z) * 0x1p-23, units = std::fabs(z - w) / unit;
  const double part = units - std::floor(units), both = slopes.c[2] + slopes.c[3];
  return both * both * Rounding(w) + std::min(of_z, of_w) * part * (1 - part) * unit * unit;
}

// The variance that rounding the elements of `m` adds to a number that depends on v * m by
// `slopes`. Elements of z and w that are the same, as under an infinite projection, have one error.
double OfElements(const Vector4& v, const Matrix& m, const Vector4& slopes) {
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    const bool is_same = IsSameInFloat(m, i);
    // The difference of the z and w elements is lost.
    const double lost = is_same ? v.c[i] * slopes.c[2] * (m.m[i][2] - m.m[i][3]) : 0;
    sum += lost * lost;
    for (int j = 0; j < 2; ++j) {
      const double slope = v.c[i] * slopes.c[j];
      sum += slope * slope * RoundingOfConstant(m.m[i][j]);
    }
    const double z = m.m[i][2], w = m.m[i][3], both = slopes.c[2] + slopes.c[3];
    const Vector4 of_pair = {{0, 0, IsExact(z) ? 0 : slopes.c[2], IsExact(w) ? 0 : slopes.c[3]}};
    sum +=
        v.c[i] * v.c[i] * (is_same ? both * both * RoundingOfConstant(w) : OfPair(z, w, of_pair));
  }
  return sum;
}

// The variance that the operations of v * m add; `m` is in float.
double OfOperations(const Vector4& v, const Matrix& m, const Vector4& slopes) {
  double sum = 0;
  int alike = 0;  // the rows up to which z and w are sums of the same products
  while (alike < 4 && IsSameInFloat(m, alike)) ++alike;
  double partial[4] = {};
  for (int i = 0; i < 4; ++i) {
    double rounded[4], sums[4];
    bool is_rounded[4];
    for (int j = 0; j < 4; ++j) {
      const double product = v.c[i] * m.m[i][j];
      rounded[j] = IsExact(v.c[i]) || IsExact(m.m[i][j]) ? 0 : Rounding(product);
      sums[j] = partial[j] + product;
      is_rounded[j] = RoundingOfSum(partial[j], product) > 0;
      partial[j] = sums[j];
    }
    for (int j = 0; j < 2; ++j) {
      const double size = rounded[j] + (is_rounded[j] ? Rounding(sums[j]) : 0);
      sum += slopes.c[j] * slopes.c[j] * size;
    }
    const double both = slopes.c[2] + slopes.c[3];
    if (i < alike) {
      sum += both * both * (rounded[3] + (is_rounded[3] ? Rounding(sums[3]) : 0));
      continue;
    }
    sum += slopes.c[2] * slopes.c[2] * rounded[2] + slopes.c[3] * slopes.c[3] * rounded[3];
    sum += OfPair(is_rounded[2] ? sums[2] : 0, is_rounded[3] ? sums[3] : 0, slopes);
  }
  return sum;
}

// The matrix as the shader or the application has it in float.
Matrix InFloat(const Matrix& matrix) {
  Matrix rounded;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j)
      rounded.m[i][j] = static_cast<double>(static_cast<float>(matrix.m[i][j]));
  }
  return rounded;
}

// The variance from multiplying two matrices, where `v` is multiplied by the first, and the number
// depends by `slopes` on the result.
double OfProduct(const Vector4& v, const Matrix& first, const Matrix& second,
                 const Vector4& slopes) {
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    Vector4 of_row = slopes;
    for (double& slope : of_row.c) slope *= v.c[i];
    sum += OfOperations(RowOf(first, i), second, of_row);
  }
  return sum;
}

}  // namespace

Chain::Chain(const VertexArithmetic& arithmetic) : arithmetic_(arithmetic) {
  const int count = arithmetic.count;
  for (int k = 0; k < count; ++k) {
    in_float_[k] = InFloat(arithmetic.matrices[k]);
    products_[k] = k == 0 ? in_float_[k] : Multiply(products_[k - 1], in_float_[k]);
  }
  for (int k = count; k-- > 0;)
    rests_[k] = k + 1 == count ? in_float_[k] : Multiply(in_float_[k], rests_[k + 1]);
}

Slopes Chain::SlopesOf(const Vector4& last) const {
  Slopes slopes;
  slopes.at[arithmetic_.count] = last;
  for (int k = arithmetic_.count; k > 0; --k)
    slopes.at[k - 1] = Before(arithmetic_.matrices[k - 1], slopes.at[k]);
  return slopes;
}

Vector4 Chain::Last(const double (&place)[3]) const {
  Vector4 v = {{place[0], place[1], place[2], 1}};
  for (int k = 0; k < arithmetic_.count; ++k) v = Transform(v, arithmetic_.matrices[k]);
  return v;
}

double Chain::SharedAt(const double (&place)[3], const Slopes& slopes) const {
  const int count = arithmetic_.count;
  const Vector4 vertex = {{place[0], place[1], place[2], 1}};
  Vector4 v = vertex;
  double sum = 0;
  for (int k = 0; k < count; ++k) {
    const Matrix& matrix = arithmetic_.matrices[k];
    sum += OfElements(v, matrix, slopes.at[k + 1]);
    if (arithmetic_.product == FloatProduct::kFromLeft && k > 0)
      sum += OfProduct(vertex, products_[k - 1], in_float_[k], slopes.at[k + 1]);
    if (arithmetic_.product == FloatProduct::kFromRight && k + 1 < count)
      sum += OfProduct(v, in_float_[k], rests_[k + 1], slopes.at[count]);
    v = Transform(v, matrix);
  }
  return sum;
}

double Chain::OwnAt(const double (&place)[3], const Slopes& slopes) const {
  const int count = arithmetic_.count;
  Vector4 v = {{place[0], place[1], place[2], 1}};
  if (arithmetic_.product != FloatProduct::kNone)
    return count > 0 ? OfOperations(v, products_[count - 1], slopes.at[count]) : 0;
  double sum = 0;
  for (int k = 0; k < count; ++k) {
    sum += OfOperations(v, in_float_[k], slopes.at[k + 1]);
    v = Transform(v, arithmetic_.matrices[k]);
  }
  return sum;
}

}  // namespace clipc::runtime::rounding
