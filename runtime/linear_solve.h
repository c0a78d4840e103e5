// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

// A linear solver for four unknowns. Not part of the public interface.
namespace clipc::runtime {

// The x with A x = b, and a bound of its rounding error.
struct Solution {
  bool singular = false;  // a pivot is zero: there is no x
  double x[4] = {};
  // The error of x[i] is about error[i] * 2^-53: |A^-1| (|L| |U| |x| + b_error), component by
  // component (Higham, "Accuracy and Stability of Numerical Algorithms", theorem 9.4). |A| instead
  // of |L| |U| would leave out the elements that elimination fills in. Scaling a row of A and b
  // does not change it.
  double error[4] = {};
};

// Gaussian elimination in double with partial pivoting, after scaling each row by a power of two to
// a largest element of about 1. The error of b[i] is b_error[i] * 2^-53.
Solution SolveLinear(const double (&a)[4][4], const double (&b)[4],
                     const double (&b_error)[4]) noexcept;

}  // namespace clipc::runtime
