// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/intrinsic.h"

// The enumerators of Intrinsic, a row of ir/intrinsics.def each. A new row compiles again whatever
// includes this header: sources with tables of functions, and no other header. A function that
// other code names is a CommonIntrinsic.
namespace clipc::ir {

enum class Intrinsic : std::uint8_t {
#define INTRINSIC(Enumerator, ...) k##Enumerator,
#include "ir/intrinsics.def"
};

}  // namespace clipc::ir
