// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/shortest_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace clipc {
namespace {

// d.ddde+xx of digits without a point.
std::string Scientific(const std::string& digits, int exponent) {
  const std::string fraction = digits.size() > 1 ? "." + digits.substr(1) : "";
  return fmt::format("{}{}e{}{:02}", digits[0], fraction, exponent < 0 ? '-' : '+',
                     std::abs(exponent));
}

// The digits with a point after as many of them as the exponent says; empty for an integer that has
// more digits than are given.
std::string Fixed(std::string digits, int exponent) {
  const int count = static_cast<int>(digits.size());
  if (exponent < 0) return "0." + std::string(-exponent - 1, '0') + digits;
  if (exponent + 1 < count) digits.insert(exponent + 1, ".");
  return exponent + 1 > count ? "" : digits;
}

}  // namespace

std::string ShortestText(float value) {
  char text[24];
  return {text, std::to_chars(text, std::end(text), value).ptr};
}

std::string ShortestText(double value) {
  if (!std::isfinite(value) || value == 0) return fmt::format("{}", value);
  // fmt finds the same digits, and has an exponent for other numbers.
  const std::string text = fmt::format("{}", std::abs(value));
  const std::size_t mantissa_end = std::min(text.find('e'), text.size());
  const std::size_t point = std::min(text.find('.'), mantissa_end);
  std::string digits = text.substr(0, mantissa_end);
  if (point < mantissa_end) digits.erase(point, 1);
  int exponent = static_cast<int>(point) - 1;
  if (mantissa_end < text.size()) exponent += std::stoi(text.substr(mantissa_end + 1));
  const std::size_t leading = digits.find_first_not_of('0');
  digits.erase(0, leading);
  exponent -= static_cast<int>(leading);
  digits.erase(digits.find_last_not_of('0') + 1);

  const std::string scientific = Scientific(digits, exponent);
  std::string fixed = Fixed(digits, exponent);
  if (fixed.empty()) fixed = fmt::format("{:.0f}", std::abs(value));
  return (value < 0 ? "-" : "") + (fixed.size() <= scientific.size() ? fixed : scientific);
}

}  // namespace clipc
