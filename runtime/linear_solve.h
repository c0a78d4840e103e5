// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

// Not part of the public interface.
namespace clipc::runtime {

// x with A x = b, and how far rounding may have moved it.
struct Solution {
  bool singular = false;  // a pivot was zero: there is no x
  double x[4] = {};
  // The error of x[i] is about error[i] * 2^-53: |A^-1| (|L| |U| |x| + b_error), component by
  // component (Higham, "Accuracy and Stability of Numerical Algorithms", theorem 9.4). |A| for |L|
  // |U| would forget what elimination fills in. Does not change when a row of A and b is scaled.
  double error[4] = {};
};

// Gaussian elimination in double with partial pivoting, after each row was scaled to a largest
// element of 1. `b_error[i] * 2^-53` is how wrong b[i] may be already.
Solution SolveLinear(const double (&a)[4][4], const double (&b)[4],
                     const double (&b_error)[4]) noexcept;

}  // namespace clipc::runtime
