// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "backend-glsl/target.h"
#include "backend-glsl/text.h"
#include "ir/type.h"

namespace clipc::glsl {

// Returns the number that ir::Literal holds as `bits`. Floats are the shortest decimals that read
// back to the same bits. Infinities and NaN, which have no decimal, are made of bits if they are
// floats and the target's core can do it, otherwise of a division.
Text LiteralText(std::uint64_t bits, ir::Scalar kind, const Target& target);

// Returns a uint in hexadecimal, with four or eight digits.
Text MaskText(std::uint32_t bits);

}  // namespace clipc::glsl
