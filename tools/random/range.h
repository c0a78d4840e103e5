// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "tools/random/type.h"

// The values that an expression may have. Generated programs keep every float a multiple of
// 2^-fraction with at most 24 bits between that and its greatest value: then every sum and product
// is exact, in any order and with fused operations too, and so a comparison never hinges on
// rounding.
namespace clipc::random {

// The components lie in [low, high] and are multiples of 2^-fraction.
struct Range {
  double low = 0, high = 0;
  int fraction = 0;

  double Largest() const { return low < -high ? -low : high < 0 ? -high : high; }
  bool IsWithin(double least, double greatest) const { return least <= low && high <= greatest; }
};

// Floats whose products are exact if there are few factors.
inline constexpr Range kSmallFloats{-16, 16, 2};

// The range of all values of an int or a uint.
Range Wild(Kind kind);
// Integers in [low, high], or Wild(kind) where they would wrap around.
Range Integers(Kind kind, double low, double high);

// Whether floats of that range and the results of adding two of them are exact.
bool IsExact(const Range& range);

Range Union(const Range& a, const Range& b);
Range Negated(const Range& a);
Range Sum(const Range& a, const Range& b);
Range Product(const Range& a, const Range& b);
Range Times(const Range& a, int count);  // the range of a sum of `count` values
Range Absolute(const Range& a);
Range Least(const Range& a, const Range& b);     // min
Range Greatest(const Range& a, const Range& b);  // max
Range RoundedDown(const Range& a);               // floor, trunc, ceil, round: within one of a

// The range of a value that is converted from one kind to another. Requires CanConvert.
Range Converted(const Range& range, Kind from, Kind to);
// Whether that conversion is defined and exact.
bool CanConvert(const Range& range, Kind from, Kind to);

// The ranges of variables, inputs and constants of a kind.
Range VariableRange(Kind kind);
Range InputRange(Kind kind);

}  // namespace clipc::random
