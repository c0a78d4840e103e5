// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "double_double.h"
#include "matrix.h"

/// An affine matrix that planes are taken through, prepared for many of them. Not part of the
/// public interface.
namespace clipc::runtime {

/// A plane in twice double's digits, with a bound of its error.
struct Bounded {
  DoubleDouble plane[4];  ///< x, y, z, w
  double error[4] = {};   ///< of each component, in units of 2^-53
};

/// The inverse of a matrix [R 0; t 1], by its cofactors (Cramer's rule): each cofactor is a
/// difference of two exact products, rounded once to twice double's digits, so that what they
/// cancel is not lost. The scales of rows and columns do not matter.
///
/// `holds` is false, and SolveLinear is for the matrix, if it is not affine, if the determinant's
/// products cancel 20 bits or more, or if an element is not 0 and not between 2^-100 and 2^100,
/// where nothing that is computed underflows or overflows.
struct AffineInverse {
  bool holds = false;
  DoubleDouble cofactor[3][3];  ///< of the element in the same place of R
  DoubleDouble reciprocal;      ///< 1 / det R
  double translation[3] = {};   ///< t
  double lost = 0;              ///< the relative error of `reciprocal`, in units of 2^-53
};

AffineInverse InverseOfAffine(const Matrix& matrix) noexcept;

/// Sets `after` to the plane after the matrix: the x with matrix * x = before, each component right
/// to about 2^-100 of its largest summand. Returns false, and sets nothing, if a component of
/// `before` is not 0 and not between 2^-200 and 2^200. Requires inverse.holds.
bool TakeThrough(const AffineInverse& inverse, const Bounded& before, Bounded& after) noexcept;

}  // namespace clipc::runtime
