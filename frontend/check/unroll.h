// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

namespace clipc::check {

// Applies [unroll(N)] to the loop that was emitted last: it ends after N iterations. "for
// Statement" in the HLSL reference has "the maximum number of times the loop is to execute", and
// vkd3d's test of it, which was checked against native, counts to 4 under [unroll(4)] where the
// condition says 8. A loop that is seen to end by then is left as it is. Reports an N that is not a
// constant.
void LimitIterations(Context& context, const ast::Attr& unroll);

}  // namespace clipc::check
