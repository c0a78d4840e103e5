// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/es100/lower_to_es100.h"

#include "legalize/legalize.h"

namespace clipc::legalize {

void LowerToEs100(Legalizer& legalizer) {
  LowerLoops(legalizer);
  // The indices of loops are the counters that LowerLoops leaves.
  LowerElements(legalizer);
}

}  // namespace clipc::legalize
