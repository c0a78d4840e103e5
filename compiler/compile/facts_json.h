// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "compiler/compile/facts.h"

namespace clipc {

// The text of --reflect, a JSON document. docs/reflection.md describes every key.
std::string FactsJson(const Facts& facts);

// Bytes as the documents have them: "0000803F".
std::string HexadecimalDigits(std::span<const std::uint8_t> bytes);

}  // namespace clipc
