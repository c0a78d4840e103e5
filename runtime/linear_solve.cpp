// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/linear_solve.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

#include "runtime/finite.h"

namespace clipc::runtime {
namespace {

// The largest share of x that elimination may lose before refinement is not trusted, in units of
// 2^-53.
constexpr double kMostLost = 0x1p46;
// The most steps of refinement, which are more than the worst system that is trusted needs.
constexpr int kSteps = 8;
// The largest rounding error of a sum of five DoubleDoubles, in units of 2^-53.
constexpr double kRoundingLeft = 0x1p-48;
// The least scaled element, but for 0, with which no product of elimination underflows to nothing.
constexpr double kLeastElement = 0x1p-400;

// The equations scaled: scaled[i][j] = a[i][j] 2^(row[i] + column[j]).
struct Scaled {
  double a[4][4];
  int row[4], column[4];
  bool keeps_digits = true;  // every element is 0 or at least kLeastElement
};

int ExponentOf(double number) { return number == 0 ? 0 : std::ilogb(number); }

Scaled Scale(const double (&a)[4][4]) {
  Scaled scaled;
  for (int j = 0; j < 4; ++j) {
    double largest = 0;
    for (const auto& row : a) largest = std::max(largest, std::fabs(row[j]));
    scaled.column[j] = -ExponentOf(largest);
    for (int i = 0; i < 4; ++i) scaled.a[i][j] = std::scalbn(a[i][j], scaled.column[j]);
  }
  for (int i = 0; i < 4; ++i) {
    double largest = 0;
    for (const double element : scaled.a[i]) largest = std::max(largest, std::fabs(element));
    scaled.row[i] = -ExponentOf(largest);
    // Each element is scaled from `a` itself: one that the first scaling made denormal keeps its
    // digits.
    for (int j = 0; j < 4; ++j) {
      scaled.a[i][j] = std::scalbn(a[i][j], scaled.column[j] + scaled.row[i]);
      if (a[i][j] != 0 && std::fabs(scaled.a[i][j]) < kLeastElement) scaled.keeps_digits = false;
    }
  }
  return scaled;
}

// P A = L U in place; L has ones on its diagonal.
struct Factors {
  double lu[4][4];
  int row_of[4] = {0, 1, 2, 3};
  bool singular = false;
};

Factors Factorise(const double (&a)[4][4]) {
  Factors factors;
  for (int row = 0; row < 4; ++row) std::copy(a[row], a[row] + 4, factors.lu[row]);
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
    x[row] = b[factors.row_of[row]];
    for (int k = 0; k < row; ++k) x[row] -= factors.lu[row][k] * x[k];
  }
  for (int row = 3; row >= 0; --row) {
    for (int k = row + 1; k < 4; ++k) x[row] -= factors.lu[row][k] * x[k];
    x[row] /= factors.lu[row][row];
  }
}

// |A^-1| residual, component by component.
void Reach(const Factors& factors, const double (&residual)[4], double (&error)[4]) {
  std::fill(error, error + 4, 0);
  for (int i = 0; i < 4; ++i) {
    // A column of the inverse says how far an error in its equation reaches.
    double unit[4] = {}, column[4];
    unit[i] = 1;
    Substitute(factors, unit, column);
    for (int j = 0; j < 4; ++j) error[j] += std::fabs(column[j]) * residual[i];
  }
}

// The scaled system with its factors, and its refined solution.
class Refinement {
 public:
  Refinement(const Scaled& scaled, const Factors& factors, const DoubleDouble (&b)[4])
      : a_(scaled.a), factors_(factors), b_(b) {
    SetResidual();
    for (int step = 0; step < kSteps; ++step) {
      double right[4], by[4];
      for (int i = 0; i < 4; ++i) right[i] = residual_[i].high;
      Substitute(factors_, right, by);
      double size[4];
      for (int i = 0; i < 4; ++i) {
        y[i] = Add(y[i], {by[i], 0});
        size[i] = y[i].high;
      }
      SetResidual();
      if (!(LargestOf(by) > 0x1p-70 * LargestOf(size))) break;
    }
  }

  // |L| |U| |y|, equation by equation.
  void BoundOfElimination(double (&bound)[4]) const {
    double upper[4];
    for (int i = 0; i < 4; ++i) {
      upper[i] = 0;
      for (int j = i; j < 4; ++j) upper[i] += std::fabs(factors_.lu[i][j] * y[j].high);
    }
    for (int i = 0; i < 4; ++i) {
      double& sum = bound[factors_.row_of[i]] = upper[i];
      for (int k = 0; k < i; ++k) sum += std::fabs(factors_.lu[i][k]) * upper[k];
    }
  }

  // The largest possible residual, equation by equation, in units of 2^-53.
  void BoundOfResidual(double (&bound)[4]) const {
    for (int i = 0; i < 4; ++i) {
      double size = std::fabs(b_[i].high);
      for (int j = 0; j < 4; ++j) size += std::fabs(a_[i][j] * y[j].high);
      bound[i] = std::fabs(residual_[i].high) * 0x1p53 + kRoundingLeft * size;
    }
  }

  DoubleDouble y[4] = {};

 private:
  void SetResidual() {
    for (int i = 0; i < 4; ++i) {
      residual_[i] = b_[i];
      for (int j = 0; j < 4; ++j) residual_[i] = Add(residual_[i], Multiply(-a_[i][j], y[j]));
    }
  }

  const double (&a_)[4][4];
  const Factors& factors_;
  const DoubleDouble (&b_)[4];
  DoubleDouble residual_[4];
};

// 2^exponent times the number; a number that would become 0 becomes the least normal number, so
// that it is seen not to be representable.
double ScaledBack(double number, int exponent) {
  const double result = std::scalbn(number, exponent);
  return result == 0 && number != 0 ? std::copysign(DBL_MIN, number) : result;
}

}  // namespace

Solution SolveLinear(const double (&a)[4][4], const DoubleDouble (&b)[4],
                     const double (&b_error)[4]) noexcept {
  Solution solution;
  const Scaled scaled = Scale(a);
  const Factors factors = Factorise(scaled.a);
  solution.singular = factors.singular;
  if (factors.singular) return solution;
  // The right side is scaled as a whole, too, to a largest component of about 1.
  bool is_zero = true;
  int most = 0;
  for (int i = 0; i < 4; ++i) {
    if (b[i].high == 0) continue;
    const int exponent = std::ilogb(b[i].high) + scaled.row[i];
    most = is_zero ? exponent : std::max(most, exponent);
    is_zero = false;
  }
  if (is_zero && LargestOf(b_error) == 0) return solution;
  DoubleDouble right[4];
  double right_error[4];
  for (int i = 0; i < 4; ++i) {
    const int exponent = scaled.row[i] - most;
    right[i] = {std::scalbn(b[i].high, exponent), std::scalbn(b[i].low, exponent)};
    right_error[i] = std::scalbn(b_error[i], exponent) + kUnderflow;
  }
  const Refinement refined(scaled, factors, right);
  double residual[4], eliminated[4], error[4], size[4];
  refined.BoundOfElimination(residual);
  Reach(factors, residual, eliminated);
  for (int i = 0; i < 4; ++i) size[i] = refined.y[i].high;
  const bool is_trusted = LargestOf(eliminated) <= kMostLost * LargestOf(size);
  if (is_trusted) refined.BoundOfResidual(residual);
  for (int i = 0; i < 4; ++i) residual[i] += right_error[i];
  Reach(factors, residual, error);
  for (int j = 0; j < 4; ++j) {
    const int exponent = scaled.column[j] + most;
    solution.x[j] = {ScaledBack(refined.y[j].high, exponent),
                     std::scalbn(refined.y[j].low, exponent)};
    solution.error[j] =
        scaled.keeps_digits ? std::scalbn(error[j], exponent) + kUnderflow : INFINITY;
  }
  return solution;
}

}  // namespace clipc::runtime
