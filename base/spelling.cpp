// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/spelling.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <utility>

namespace clipc {
std::string ToLower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = ToLower(c);
  return lower;
}

std::string ToUpper(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return upper;
}

bool EqualLettersIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](char x, char y) { return ToLower(x) == ToLower(y); });
}

std::string ReasonOf(int error) {
  std::string reason = std::strerror(error);
  if (!reason.empty()) reason[0] = ToLower(reason[0]);
  return reason;
}

std::string WithCount(std::uint64_t count, std::string_view what) {
  std::string text = std::to_string(count) + " ";
  text += what;
  if (count != 1) text += 's';
  return text;
}

int EditDistance(std::string_view a, std::string_view b, int limit) {
  if (std::abs(static_cast<int>(a.size()) - static_cast<int>(b.size())) > limit) return limit + 1;
  const auto same = [&](std::size_t i, std::size_t j) { return ToLower(a[i]) == ToLower(b[j]); };
  // The rows of the table that the last three prefixes of `a` fill.
  std::vector<int> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, above);
    std::swap(above, row);
    int best = row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] =
          std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same(i - 1, j - 1) ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && same(i - 1, j - 2) && same(i - 2, j - 1);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
      best = std::min(best, row[j]);
    }
    if (best > limit + 1) return limit + 1;  // a swap reaches back over one row, and costs one
  }
  return std::min(row[b.size()], limit + 1);
}

std::vector<std::string_view> NearNames(std::string_view name,
                                        std::span<const std::string_view> candidates) {
  // Every name of one letter is one edit away from every other.
  const int limit = name.size() < 2 ? 0 : std::max<int>(1, static_cast<int>(name.size()) / 3);
  std::vector<std::pair<int, std::string_view>> near;
  if (name.size() > 64) return {};
  for (std::string_view candidate : candidates) {
    if (const int distance = EditDistance(name, candidate, limit); distance <= limit)
      near.emplace_back(distance, candidate);
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string_view> names;
  for (const auto& [distance, candidate] : near) {
    if (names.size() < 3 && std::find(names.begin(), names.end(), candidate) == names.end())
      names.push_back(candidate);
  }
  return names;
}

}  // namespace clipc
