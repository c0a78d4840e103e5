// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace clipc::rules {

// The most calls inside each other that a rule follows; deeper ones are the error CheckTooDeep.
inline constexpr int kMaxCallDepth = 200;

}  // namespace clipc::rules
