// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "backend-glsl/target.h"
#include "backend-glsl/text.h"
#include "ir/type.h"

namespace clipc::glsl {

// `bits` as ir::Literal holds them. Floats are the shortest decimals that read back to the same
// bits; what no decimal says (infinities, NaN) is made of bits where the target can, else of a
// division.
Text LiteralText(std::uint64_t bits, ir::Scalar kind, const Target& target);

}  // namespace clipc::glsl
