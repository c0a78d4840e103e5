// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <compare>
#include <cstdint>

namespace clipc {

// A dense index into the one Arena that owns values of type T. Ids of different kinds do not
// convert.
template <typename T>
struct Id {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::uint32_t index = kNone;
  explicit constexpr operator bool() const { return index != kNone; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

}  // namespace clipc
