// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "runtime/matrix.h"

// Vectors in several precisions. `float` is what a vertex shader computes: each operation rounds,
// nothing is fused, sums go from left to right. That only holds where the compiler lets it: this
// folder is built with -ffp-contract=off and -fno-tree-slp-vectorize, and a test (float32_test.cpp)
// notices when it did not help.
namespace clipc::study {

// For what counts as exact.
#if defined(__SIZEOF_FLOAT128__)
using Wide = __float128;
#else
using Wide = long double;
#endif

template <typename T>
struct Vec4 {
  T c[4];
  T& operator[](int i) { return c[i]; }
  const T& operator[](int i) const { return c[i]; }
};

template <typename T>
struct Mat4 {  // m[row][column], for row vectors
  T m[4][4];
};

template <typename To, typename From>
Vec4<To> ConvertTo(const Vec4<From>& from) {
  Vec4<To> to;
  for (int i = 0; i < 4; ++i) to[i] = static_cast<To>(from[i]);
  return to;
}

template <typename To>
Mat4<To> ConvertTo(const runtime::Matrix& from) {
  Mat4<To> to;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) to.m[i][j] = static_cast<To>(from.m[i][j]);
  }
  return to;
}

template <typename To>
Vec4<To> ConvertTo(const runtime::Plane& from) {
  return {{static_cast<To>(from.x), static_cast<To>(from.y), static_cast<To>(from.z),
           static_cast<To>(from.w)}};
}

inline Vec4<float> VectorOf(const runtime::Float4& from) {
  return {{from.x, from.y, from.z, from.w}};
}

template <typename T>
T Dot(const Vec4<T>& a, const Vec4<T>& b) {
  T sum = a[0] * b[0];
  for (int i = 1; i < 4; ++i) sum = sum + a[i] * b[i];
  return sum;
}

// v * m
template <typename T>
Vec4<T> Transform(const Vec4<T>& v, const Mat4<T>& m) {
  Vec4<T> to;
  for (int j = 0; j < 4; ++j) to[j] = Dot(v, Vec4<T>{{m.m[0][j], m.m[1][j], m.m[2][j], m.m[3][j]}});
  return to;
}

// a * b
template <typename T>
Mat4<T> Multiply(const Mat4<T>& a, const Mat4<T>& b) {
  Mat4<T> product;
  for (int i = 0; i < 4; ++i) {
    const Vec4<T> row = Transform(Vec4<T>{{a.m[i][0], a.m[i][1], a.m[i][2], a.m[i][3]}}, b);
    for (int j = 0; j < 4; ++j) product.m[i][j] = row[j];
  }
  return product;
}

// m * plane, m applied to a column: planes go the other way than points.
template <typename T>
Vec4<T> PlaneThrough(const Mat4<T>& m, const Vec4<T>& plane) {
  Vec4<T> to;
  for (int i = 0; i < 4; ++i)
    to[i] = Dot(Vec4<T>{{m.m[i][0], m.m[i][1], m.m[i][2], m.m[i][3]}}, plane);
  return to;
}

// By cofactors, every operation in T: what applications with a float matrix library do.
template <typename T>
Mat4<T> InverseOf(const Mat4<T>& matrix) {
  const auto& m = matrix.m;
  const auto minor = [&](int row, int column) {
    T d[3][3];
    for (int i = 0, r = 0; i < 4; ++i) {
      if (i == row) continue;
      for (int j = 0, c = 0; j < 4; ++j) {
        if (j != column) d[r][c++] = m[i][j];
      }
      ++r;
    }
    const T value = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                    d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                    d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    return (row + column) % 2 == 0 ? value : -value;
  };
  T determinant = 0;
  for (int j = 0; j < 4; ++j) determinant += m[0][j] * minor(0, j);
  Mat4<T> inverse;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) inverse.m[i][j] = minor(j, i) / determinant;
  }
  return inverse;
}

// Equal seeds give equal numbers on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  double Unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }  // [0, 1)
  double Between(double low, double high) { return low + (high - low) * Unit(); }
  double Magnitude(double low, double high) {
    return low * std::pow(high / low, Unit());
  }  // even in its logarithm
  std::uint32_t Below(std::uint32_t limit) { return static_cast<std::uint32_t>(bits_() % limit); }
  void Direction(double (&to)[3]) {
    double length;
    do {
      for (double& x : to) x = Between(-1, 1);
      length = std::sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
    } while (length < 0.1 || length > 1);
    for (double& x : to) x /= length;
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace clipc::study
