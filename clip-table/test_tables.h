// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "clip-table/clip_table.h"

// Good clip tables for property tests; equal seeds give equal tables on every machine.
namespace clipc::clip_table {

class RandomTable {
 public:
  explicit RandomTable(std::uint32_t seed) : random_(seed) {}

  std::uint32_t Below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }

  // A text of identifiers, HLSL punctuation and characters that are hard to quote.
  std::string Text() {
    static const char* const kPieces[] = {
        "planes", "[2]",  ".",    "$Globals", "float4(a, b)", "\"", "\\", "?\?/", "\n", "\t",
        "é",      "平面", "\x7f", "7",        "\x01",         "*/", "//", " "};
    std::string text;
    for (std::uint32_t n = Below(6); n > 0; --n) text += kPieces[Below(std::size(kPieces))];
    return text;
  }

  ClipTable Next() {
    ClipTable table;
    table.entry = Text();
    table.profile = Text();
    table.lowering = static_cast<Lowering>(Below(5));
    table.plane_space = static_cast<PlaneSpace>(Below(3));
    if (!Supports(table.lowering, table.plane_space)) table.plane_space = PlaneSpace::kClip;
    const std::uint32_t count =
        Below(table.lowering == Lowering::kNearPlane ? 2 : kMaxClipPlanes + 1);
    for (std::uint32_t i = 0; i < count; ++i) {
      Plane& plane = table.planes.emplace_back(Plane{i, Text(), std::nullopt});
      if (table.lowering != Lowering::kLevel9 && Below(4) == 0) continue;
      const std::uint32_t row = Below(Below(2) ? 64 : 65536);
      plane.constant =
          Constant{Text(), Below(3), Below(70000), Below(3), row, 16 * row, Text(), Text()};
    }
    table.enable_mask = EnableMask(table.lowering, count);
    return table;
  }

 private:
  std::mt19937 random_;
};

// Flips bits, and cuts, repeats and overwrites bytes, as happens to files. Always changes
// something.
inline std::string Damaged(std::string bytes, RandomTable& random) {
  const std::string before = bytes;
  while (bytes == before) {
    for (std::uint32_t n = 1 + random.Below(3); n > 0 && !bytes.empty(); --n) {
      const std::uint32_t at = random.Below(static_cast<std::uint32_t>(bytes.size()));
      switch (random.Below(5)) {
        case 0: bytes[at] = static_cast<char>(bytes[at] ^ 1 << random.Below(8)); break;
        case 1: bytes.resize(at); break;
        case 2: bytes.insert(at, bytes.substr(at, 1 + random.Below(40))); break;
        case 3: bytes.erase(at, 1 + random.Below(40)); break;
        default: bytes[at] = static_cast<char>(random.Below(256)); break;
      }
    }
    if (bytes.empty()) break;
  }
  return bytes;
}

}  // namespace clipc::clip_table
