// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>

namespace clipc {

// The SHA-256 of `text` (FIPS 180-4), as 64 hexadecimal digits: equal digests mean equal texts,
// also where somebody writes texts to deceive.
std::string Sha256(std::string_view text);

}  // namespace clipc
