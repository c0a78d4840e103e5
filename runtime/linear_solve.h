// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "double_double.h"

/// A linear solver for four unknowns. Not part of the public interface.
namespace clipc::runtime {

/// The x with A x = b, and a bound of its error.
struct Solution {
  bool singular = false;  ///< a pivot is zero: there is no x
  DoubleDouble x[4] = {};
  /// The error of x[i] is about error[i] * 2^-53, component by component: |A^-1| (|b - A x| +
  /// b_error), with the residual as it was computed and what its own rounding may hide. Infinite
  /// where elements are so far apart that elimination loses some without a trace.
  double error[4] = {};
};

/// Gaussian elimination in double with partial pivoting, then steps of refinement with a residual
/// of twice double's digits (Higham, "Accuracy and Stability of Numerical Algorithms", chapter 12).
/// Columns and then rows are scaled by powers of two to a largest element of about 1, so that a
/// translation of any length is as good as none. Where elimination alone may have lost 46 bits or
/// more, refinement is not trusted, and `error` is the bound of elimination, |A^-1| |L| |U| |x|
/// (theorem 9.4 there). The error of b[i] is b_error[i] * 2^-53.
Solution SolveLinear(const double (&a)[4][4], const DoubleDouble (&b)[4],
                     const double (&b_error)[4]) noexcept;

}  // namespace clipc::runtime
