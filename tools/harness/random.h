// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "tools/harness/transform.h"

namespace clipc::harness {

// A source of random numbers. Equal seeds give equal numbers on every machine, which the standard
// distributions do not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  // A random number in [0, 1).
  double Unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double Between(double low, double high) { return low + (high - low) * Unit(); }
  // A random number between `low` and `high`, uniform in its logarithm: for sizes and distances.
  double Magnitude(double low, double high) { return low * std::pow(high / low, Unit()); }
  // A random number in [0, limit).
  std::uint32_t Below(std::uint32_t limit) { return static_cast<std::uint32_t>(bits_() % limit); }
  // A random unit vector.
  Vector Direction() {
    Vector v;
    double length;
    do {
      v.x = Between(-1, 1), v.y = Between(-1, 1), v.z = Between(-1, 1);
      length = std::sqrt(Dot(v, v));
    } while (length < 0.1 || length > 1);
    return v / length;
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace clipc::harness
