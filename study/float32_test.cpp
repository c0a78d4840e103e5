// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cmath>

#include <gtest/gtest.h>

#include "study/numbers.h"

// The emulation of float32 must round: here with the flags of this project, and as a mutation with
// g++'s SLP vectoriser.
#ifdef CLIPC_HAS_ROUND_TRIP
extern "C" void RoundTrip_guarded(const double* a, const double* b, const double* c, double* plane,
                                  double* through);
extern "C" void RoundTrip_provoked(const double* a, const double* b, const double* c, double* plane,
                                   double* through);
#endif

namespace clipc::study {
namespace {

#ifdef CLIPC_HAS_ROUND_TRIP
using RoundTrip = void (*)(const double* a, const double* b, const double* c, double* plane,
                           double* through);

// The difference of the result from one whose roundings no compiler can take away.
double Difference(RoundTrip run) {
  double worst = 0;
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    double a[16], b[16], c[4], plane[4], through[5];
    for (double& x : a) x = random.Between(-1, 1);
    for (int i = 0; i < 16; ++i) b[i] = random.Between(-1, 1) + (i % 5 == 0 ? 8 : 0);
    for (double& x : c) x = random.Between(-1, 1);
    run(a, b, c, plane, through);
    for (int i = 0; i < 4; ++i) {
      double expected = 0;
      for (int j = 0; j < 4; ++j) {
        double element = 0;
        for (int k = 0; k < 4; ++k) element += a[4 * i + k] * b[4 * k + j];
        const volatile float rounded = static_cast<float>(plane[j]);
        expected += element * static_cast<double>(rounded);
      }
      worst = std::fmax(worst, std::fabs(expected - through[i]));
    }
  }
  return worst;
}

TEST(Float32, RoundsWithTheProjectsFlags) {
  if (!__builtin_cpu_supports("avx")) GTEST_SKIP() << "the fault needs AVX";
  EXPECT_LT(Difference(RoundTrip_guarded), 1e-13);
}

#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ == 12 && \
    !defined(__SANITIZE_ADDRESS__) && defined(NDEBUG)
TEST(Float32, TheFaultThatTheFlagsGuardAgainstIsThere) {
  if (!__builtin_cpu_supports("avx")) GTEST_SKIP() << "the fault needs AVX";
  EXPECT_GT(Difference(RoundTrip_provoked), 1e-9);
}
#endif
#endif

TEST(Float32, SumsFromTheLeftAndFusesNothing) {
  // 1 + 2^-24 rounds to 1 each time; from the right the two halves would add up first.
  const Vec4<float> a = {{1, 0x1p-24f, 0x1p-24f, 0}}, ones = {{1, 1, 1, 1}};
  EXPECT_EQ(Dot(a, ones), 1.0f);
  // (1 + e)^2 - (1 + 2 e) is 0 when the product rounds, e^2 when it is fused.
  const Vec4<float> b = {{-(1 + 0x1p-11f), 1 + 0x1p-12f, 0, 0}}, c = {{1, 1 + 0x1p-12f, 0, 0}};
  EXPECT_EQ(Dot(b, c), 0.0f);
}

TEST(Float32, InverseIsOne) {
  Random random(4);
  Mat4<double> m;
  for (auto& row : m.m) {
    for (double& x : row) x = random.Between(-1, 1);
  }
  const Mat4<double> one = Multiply(m, InverseOf(m));
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(one.m[i][j], i == j, 1e-13);
  }
}

}  // namespace
}  // namespace clipc::study
