// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "frontend/lex/token.h"

namespace clipc {

// 128 bits that stand for a text after preprocessing, wherever its words were written. Two texts
// with the same digest are taken for one text: by chance that does not happen, and a shader that
// forges it harms only its own permutations.
using TokenDigest = std::array<std::uint64_t, 2>;

TokenDigest DigestOf(const Tokens& tokens);

// The digest of a list of texts.
TokenDigest DigestOf(std::span<const std::string> texts);

}  // namespace clipc
