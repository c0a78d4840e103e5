// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "legalize/legalizer.h"

// The steps of LowerToEs100.
namespace clipc::legalize {

// Rewrites loops for targets that accept only loops that count from constant to constant: the index
// is declared in the head, and a further condition leaves the loop. CheckTarget refuses other
// loops.
//
//   for (i = 0; i < 4 && more; ++i) ..  =>  for (int i = 0; i < 4; i++) { if (!more) break; .. }
void LowerLoops(Legalizer& legalizer);

// Replaces elements whose index is not constant, for targets that accept such an index of uniforms
// only. An index out of range takes the last element. A vector or matrix may keep the index of a
// loop.
//
//   a[i]        =>  element(a, i) with { if (i == 0) return a[0]; ...; return a[3]; }
//   a[i].x = v  =>  set_element_x(i, v, a) with { if (i == 0) return a[0].x = v; ... }
//   f(a[i])     =>  index = i, value = a[index], result = f(value), a[index] = value, result
void LowerElements(Legalizer& legalizer);

}  // namespace clipc::legalize
