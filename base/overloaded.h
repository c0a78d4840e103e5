// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>

namespace clipc {

// A visitor made of lambdas, std::visit(Overloaded{[](const A&) {...}, [](const B&) {...}},
// variant), which does not compile if an alternative is forgotten.
template <typename... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <typename... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

// std::visit for one variant that has a value. A switch instead of std::visit's table of functions
// lets the compiler inline the visitor into the walks of the trees.
template <typename Visitor, typename Variant>
constexpr decltype(auto) Visit(Visitor&& visitor, Variant& variant) {
  constexpr std::size_t kSize = std::variant_size_v<std::remove_const_t<Variant>>;
  static_assert(kSize <= 20);
#define CLIPC_CASE(N)                                                       \
  case N:                                                                   \
    if constexpr ((N) < kSize) return visitor(*std::get_if<(N)>(&variant)); \
    [[fallthrough]];
  // clang-format off
  switch (variant.index()) {
    CLIPC_CASE(0) CLIPC_CASE(1) CLIPC_CASE(2) CLIPC_CASE(3) CLIPC_CASE(4)
    CLIPC_CASE(5) CLIPC_CASE(6) CLIPC_CASE(7) CLIPC_CASE(8) CLIPC_CASE(9)
    CLIPC_CASE(10) CLIPC_CASE(11) CLIPC_CASE(12) CLIPC_CASE(13) CLIPC_CASE(14)
    CLIPC_CASE(15) CLIPC_CASE(16) CLIPC_CASE(17) CLIPC_CASE(18) CLIPC_CASE(19)
    default: __builtin_unreachable();
  }
  // clang-format on
#undef CLIPC_CASE
}

}  // namespace clipc
