// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/legalize/es100/lower_to_es100.h"

#include "backend-glsl/legalize/legalize.h"

namespace clipc::glsl {

void LowerToEs100(Legalizer& legalizer) {
  LowerLoops(legalizer);
  // The indices of loops are the counters that LowerLoops leaves.
  LowerElements(legalizer);
}

}  // namespace clipc::glsl
