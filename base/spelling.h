// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clipc {

// Changes the case of ASCII letters and keeps other characters.
constexpr char ToLower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
std::string ToLower(std::string_view text);
std::string ToUpper(std::string_view text);
bool EqualLettersIgnoringCase(std::string_view a, std::string_view b);  // of the same length
inline bool EqualIgnoringCase(std::string_view a, std::string_view b) {
  return a.size() == b.size() && EqualLettersIgnoringCase(a, b);
}

// The system's words for a value of errno, as the end of a message: "no such file or directory".
std::string ReasonOf(int error);

// "1 element", "2 elements".
std::string WithCount(std::uint64_t count, std::string_view what);

// The number of letters to insert, delete, replace or swap with their neighbour that turn one name
// into the other (optimal string alignment), without regard to case. Returns `limit + 1` if the
// number exceeds `limit`.
int EditDistance(std::string_view a, std::string_view b, int limit);

// The candidates that a user who wrote `name` probably meant, nearest first, at most three. A
// candidate may be as many edits away as a third of the name's length, but always one; a name of
// one letter is near to none.
std::vector<std::string_view> NearNames(std::string_view name,
                                        std::span<const std::string_view> candidates);

}  // namespace clipc
