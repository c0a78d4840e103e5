// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/numbers.h"

// A float32 emulation in the small: a plane is solved for in double, rounded to float, and used in
// double again. g++ 12 with AVX and its SLP vectoriser drops that rounding. `plane` gets the plane
// before it was rounded, `through` what the rounded one became after the product of the
// matrices.
extern "C" void CLIPC_ROUND_TRIP(const double* a, const double* b, const double* c, double* plane,
                                 double* through);

using clipc::study::Mat4;
using clipc::study::Vec4;

static Mat4<double> Load(const double* from) {
  Mat4<double> m;
  for (int i = 0; i < 16; ++i) m.m[i / 4][i % 4] = from[i];
  return m;
}

// Gaussian elimination without pivoting, enough for matrices with a large diagonal.
static Vec4<double> Solve(Mat4<double> m, Vec4<double> right) {
  Vec4<double> x{};
  for (int k = 0; k < 4; ++k) {
    for (int i = k + 1; i < 4; ++i) {
      const double f = m.m[i][k] / m.m[k][k];
      for (int j = k; j < 4; ++j) m.m[i][j] -= f * m.m[k][j];
      right[i] -= f * right[k];
    }
  }
  for (int i = 3; i >= 0; --i) {
    double sum = right[i];
    for (int j = i + 1; j < 4; ++j) sum -= m.m[i][j] * x[j];
    x[i] = sum / m.m[i][i];
  }
  return x;
}

extern "C" void CLIPC_ROUND_TRIP(const double* a, const double* b, const double* c, double* plane,
                                 double* through) {
  const Mat4<double> first = Load(a), second = Load(b);
  const Mat4<double> product = clipc::study::Multiply(first, second);
  const Vec4<double> solved = Solve(second, {{c[0], c[1], c[2], c[3]}});
  const Vec4<float> rounded = clipc::study::ConvertTo<float>(solved);
  const Vec4<double> hoisted =
      clipc::study::PlaneThrough(product, clipc::study::ConvertTo<double>(rounded));
  const Vec4<float> narrow = clipc::study::ConvertTo<float>(hoisted);
  for (int i = 0; i < 4; ++i) {
    plane[i] = solved[i];
    through[i] = hoisted[i];
  }
  through[4] = static_cast<double>(narrow[0]) + static_cast<double>(rounded[1]);
}
