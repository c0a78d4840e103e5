// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clipc {

// ASCII lower case.
std::string ToLower(std::string_view text);
bool EqualIgnoringCase(std::string_view a, std::string_view b);

// Letters to insert, delete, replace or swap with their neighbour to make one name of the other
// (optimal string alignment), without regard to case; `limit + 1` as soon as it must exceed
// `limit`.
int EditDistance(std::string_view a, std::string_view b, int limit);

// The candidates that a user who wrote `name` probably meant, nearest first, at most three: those
// within a third of the name's length, at least one edit.
std::vector<std::string_view> NearNames(std::string_view name,
                                        std::span<const std::string_view> candidates);

}  // namespace clipc
