// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>

#include "frontend/lex/token.h"

namespace clipc {

// 128 bits that stand for a text after preprocessing, wherever its words were written. Two texts
// have the same by chance once in 2^128; a shader that forges that harms only its own permutations.
using TokenDigest = std::array<std::uint64_t, 2>;

TokenDigest DigestOf(const Tokens& tokens);

}  // namespace clipc
