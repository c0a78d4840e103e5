// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/range.h"

#include <algorithm>
#include <cmath>

namespace clipc::random {
namespace {

constexpr double kLeastInt = -0x1p31, kGreatestInt = 0x1p31 - 1, kGreatestUint = 0x1p32 - 1;
constexpr double kExactInt = 0x1p22;

}  // namespace

Range Wild(Kind kind) {
  return kind == Kind::kUint ? Range{0, kGreatestUint} : Range{kLeastInt, kGreatestInt};
}

Range Integers(Kind kind, double low, double high) {
  const Range wild = Wild(kind);
  const Range range{low, high};
  return range.IsWithin(wild.low, wild.high) ? range : wild;
}

bool IsExact(const Range& range) {
  return range.fraction <= 14 && std::ldexp(range.Largest(), range.fraction) <= 0x1p22;
}

Range Union(const Range& a, const Range& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high), std::max(a.fraction, b.fraction)};
}

Range Negated(const Range& a) { return {-a.high, -a.low, a.fraction}; }

Range Sum(const Range& a, const Range& b) {
  return {a.low + b.low, a.high + b.high, std::max(a.fraction, b.fraction)};
}

Range Product(const Range& a, const Range& b) {
  const double corners[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  return {std::ranges::min(corners), std::ranges::max(corners), a.fraction + b.fraction};
}

Range Times(const Range& a, int count) { return {a.low * count, a.high * count, a.fraction}; }

Range Absolute(const Range& a) {
  if (a.low >= 0) return a;
  return {a.high < 0 ? -a.high : 0, a.Largest(), a.fraction};
}

Range Least(const Range& a, const Range& b) {
  return {std::min(a.low, b.low), std::min(a.high, b.high), std::max(a.fraction, b.fraction)};
}

Range Greatest(const Range& a, const Range& b) {
  return {std::max(a.low, b.low), std::max(a.high, b.high), std::max(a.fraction, b.fraction)};
}

Range RoundedDown(const Range& a) { return {std::floor(a.low), std::ceil(a.high), 0}; }

Range Converted(const Range& range, Kind from, Kind to) {
  if (to == Kind::kBool || from == Kind::kBool) return {0, 1};
  if (to == Kind::kFloat) return range;
  const Range whole = from == Kind::kFloat ? Range{std::trunc(range.low), std::trunc(range.high)}
                                           : Range{range.low, range.high};
  return Integers(to, whole.low, whole.high);
}

bool CanConvert(const Range& range, Kind from, Kind to) {
  if (to == Kind::kFloat) return range.IsWithin(-kExactInt, kExactInt);
  if (from == Kind::kFloat && to == Kind::kUint) return range.low >= 0;
  return true;
}

Range VariableRange(Kind kind) {
  constexpr Range kRanges[] = {{-128, 128, 2}, {-128, 128}, {0, 128}, {0, 1}};
  return kRanges[static_cast<int>(kind)];
}

Range InputRange(Kind kind) {
  constexpr Range kRanges[] = {{-4, 4, 2}, {-4, 7}, {0, 7}, {0, 1}};
  return kRanges[static_cast<int>(kind)];
}

}  // namespace clipc::random
