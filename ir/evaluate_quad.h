// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ir/evaluate.h"
#include "ir/evaluate_math.h"

// How the pixels of a quad know of each other. Each runs alone and notes the operands of which a
// neighbour may ask; then all run again with what was noted, until they note the same as before.
// The first operand that depends on no neighbour is right after one run, what depends on that one
// after two, and so on, so that this ends.
namespace clipc::ir {

// The number of the calls and iterations inside of which an expression is evaluated, where `outer`
// is that of the ones around the innermost, and `inner` the innermost call or iteration itself.
inline std::uint64_t FlowIn(std::uint64_t outer, std::uint64_t inner) {
  return ((outer << 25 | outer >> 39) ^ (inner + 1)) * 0x9e3779b97f4a7c15u;
}

// The operands that a pixel noted: the same place in the program within the same iterations has the
// same key in all pixels.
using QuadKey = std::pair<std::uint64_t, std::uint32_t>;
using QuadNotes = std::array<std::map<QuadKey, std::vector<Word>>, kQuadPixels>;

// The neighbours of one pixel.
class Neighbours {
 public:
  // Pixel number `pixel` knows what all noted before, and notes its own operands in `notes`.
  Neighbours(std::size_t pixel, const QuadNotes& before, QuadNotes& notes)
      : pixel_(pixel), before_(before), notes_(notes) {}

  // The operands of all four pixels; none where one of them does not come by.
  using Operands = std::array<const Word*, kQuadPixels>;
  std::optional<Operands> Ask(QuadKey key, std::span<const Word> own);

  std::size_t pixel() const { return pixel_; }
  // The pixels whose difference, second - first, is the derivative of this pixel along x or y.
  std::size_t FirstAlongX() const { return pixel_ & 2; }
  std::size_t SecondAlongX() const { return pixel_ | 1; }
  std::size_t FirstAlongY() const { return pixel_ & 1; }
  std::size_t SecondAlongY() const { return pixel_ | 2; }

 private:
  std::size_t pixel_;
  const QuadNotes& before_;
  QuadNotes& notes_;
};

}  // namespace clipc::ir
