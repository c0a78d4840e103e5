// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

namespace clipc {

// The text of std::to_chars without a format: the shortest that reads back as the same number, with
// an exponent where that is shorter; "inf" and "nan" for what is not a number.
std::string ShortestText(float value);

// The same, without the 100 KB of tables that libc++'s has for numbers of 64 bits.
std::string ShortestText(double value);

}  // namespace clipc
