// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

namespace clipc {

// A place in the user's text: the first and the last token of a phrase (not one past it). The
// numbers are opaque: only the Source that they come from (frontend/lex/source.h) resolves them to
// file, line and macro expansion. Zero is not a place.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  explicit constexpr operator bool() const { return begin != 0; }
  friend constexpr bool operator==(Span, Span) = default;
};

// The place from the first token of `first` to the last token of `last`.
constexpr Span Cover(Span first, Span last) {
  if (!first) return last;
  if (!last) return first;
  return {first.begin, last.end};
}

}  // namespace clipc
