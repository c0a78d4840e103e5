// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/linear_solve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clipc::runtime {
namespace {

// P D A = L U in place; L has ones on its diagonal.
struct Factors {
  double lu[4][4];
  double row_scale[4];
  int row_of[4] = {0, 1, 2, 3};
  bool singular = false;
};

Factors Factorise(const double (&a)[4][4]) {
  Factors factors;
  for (int row = 0; row < 4; ++row) {
    double largest = 0;
    for (const double element : a[row]) largest = std::max(largest, std::fabs(element));
    // A power of two, so that scaling rounds nothing.
    factors.row_scale[row] = largest > 0 ? std::exp2(-std::ilogb(largest)) : 0;
    for (int column = 0; column < 4; ++column)
      factors.lu[row][column] = a[row][column] * factors.row_scale[row];
  }
  for (int k = 0; k < 4; ++k) {
    int pivot = k;
    for (int row = k + 1; row < 4; ++row) {
      if (std::fabs(factors.lu[row][k]) > std::fabs(factors.lu[pivot][k])) pivot = row;
    }
    if (!(std::fabs(factors.lu[pivot][k]) > 0)) {
      factors.singular = true;
      return factors;
    }
    std::swap(factors.lu[pivot], factors.lu[k]);
    std::swap(factors.row_of[pivot], factors.row_of[k]);
    for (int row = k + 1; row < 4; ++row) {
      const double factor = factors.lu[row][k] /= factors.lu[k][k];
      for (int column = k + 1; column < 4; ++column)
        factors.lu[row][column] -= factor * factors.lu[k][column];
    }
  }
  return factors;
}

void Substitute(const Factors& factors, const double (&b)[4], double (&x)[4]) {
  for (int row = 0; row < 4; ++row) {
    const int from = factors.row_of[row];
    x[row] = b[from] * factors.row_scale[from];
    for (int k = 0; k < row; ++k) x[row] -= factors.lu[row][k] * x[k];
  }
  for (int row = 3; row >= 0; --row) {
    for (int k = row + 1; k < 4; ++k) x[row] -= factors.lu[row][k] * x[k];
    x[row] /= factors.lu[row][row];
  }
}

}  // namespace

Solution SolveLinear(const double (&a)[4][4], const double (&b)[4],
                     const double (&b_error)[4]) noexcept {
  Solution solution;
  const Factors factors = Factorise(a);
  solution.singular = factors.singular;
  if (factors.singular) return solution;
  Substitute(factors, b, solution.x);
  double upper[4];  // |U| |x|
  for (int i = 0; i < 4; ++i) {
    upper[i] = 0;
    for (int j = i; j < 4; ++j) upper[i] += std::fabs(factors.lu[i][j] * solution.x[j]);
  }
  for (int i = 0; i < 4; ++i) {
    const int from = factors.row_of[i];
    double residual = upper[i];  // |L| |U| |x|
    for (int k = 0; k < i; ++k) residual += std::fabs(factors.lu[i][k]) * upper[k];
    residual = residual / factors.row_scale[from] + b_error[from];
    // A column of the inverse says how far an error in its equation reaches.
    double unit[4] = {}, column[4];
    unit[from] = 1;
    Substitute(factors, unit, column);
    for (int j = 0; j < 4; ++j) solution.error[j] += std::fabs(column[j]) * residual;
  }
  return solution;
}

}  // namespace clipc::runtime
