// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/harness/camera.h"
#include "tools/harness/random.h"

// Vectors in several precisions. `float` computes as a vertex shader does: each operation rounds,
// nothing is fused, sums are taken from left to right. Compilers may break that: the project is
// built with -ffp-contract=off and -fno-tree-slp-vectorize, and float32_test.cpp fails where these
// do not help.
namespace clipc::study {

using harness::Camera;
using harness::Random;
using harness::Vector;
using runtime::Matrix;
using runtime::Plane;

// The precision that counts as exact.
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

inline Vector NormalOf(const Plane& plane) { return {plane.x, plane.y, plane.z}; }
inline Vector RowOf(const Matrix& m, int i) { return {m.m[i][0], m.m[i][1], m.m[i][2]}; }

template <typename To, typename From>
Vec4<To> ConvertTo(const Vec4<From>& from) {
  Vec4<To> to;
  for (int i = 0; i < 4; ++i) to[i] = static_cast<To>(from[i]);
  return to;
}

template <typename To>
Mat4<To> ConvertTo(const Matrix& from) {
  Mat4<To> to;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) to.m[i][j] = static_cast<To>(from.m[i][j]);
  }
  return to;
}

template <typename To>
Vec4<To> ConvertTo(const Plane& from) {
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

// m * plane: the plane of `to` space in `from` space, where points go by v * m from `from` to `to`.
template <typename T>
Vec4<T> PlaneThrough(const Mat4<T>& m, const Vec4<T>& plane) {
  Vec4<T> to;
  for (int i = 0; i < 4; ++i)
    to[i] = Dot(Vec4<T>{{m.m[i][0], m.m[i][1], m.m[i][2], m.m[i][3]}}, plane);
  return to;
}

// The inverse by cofactors, every operation in T, as matrix libraries of float compute it.
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

}  // namespace clipc::study
