// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace clipc {

// A set of different words, known when clipc is built, that finds a word's position by one hash
// and, almost always, one comparison.
template <std::size_t N>
class WordIndex {
 public:
  static constexpr std::size_t kNone = N;

  constexpr explicit WordIndex(const std::array<std::string_view, N>& words) : words_(words) {
    slots_.fill(static_cast<std::uint16_t>(kNone));
    for (std::size_t i = 0; i < N; ++i) {
      std::size_t slot = FirstSlot(words[i]);
      while (slots_[slot] != kNone) slot = NextSlot(slot);
      slots_[slot] = static_cast<std::uint16_t>(i);
      lengths_[FirstLetter(words[i])] |= LengthBit(words[i]);
    }
  }

  // Returns false for most words that are not in the set, and never for one that is, in whatever
  // case.
  constexpr bool MayHave(std::string_view word) const {
    return (lengths_[FirstLetter(word)] & LengthBit(word)) != 0;
  }
  // The position of `word` in the array, or kNone.
  constexpr std::size_t Find(std::string_view word) const {
    if (!MayHave(word)) return kNone;
    std::size_t slot = FirstSlot(word);
    while (slots_[slot] != kNone && words_[slots_[slot]] != word) slot = NextSlot(slot);
    return slots_[slot];
  }
  constexpr bool Has(std::string_view word) const { return Find(word) != kNone; }

 private:
  static constexpr std::size_t kSlots = std::bit_ceil(4 * N);

  // A hash of the length and four letters, which rarely collides for words of a language.
  static constexpr std::size_t FirstSlot(std::string_view word) {
    const std::size_t size = word.size();
    if (size == 0) return 0;
    std::uint32_t hash = static_cast<std::uint32_t>(size);
    for (const std::size_t i : {std::size_t{0}, size / 3, size / 2, size - 1}) {
      hash = hash * 0x9E3779B1u + static_cast<unsigned char>(word[i]);
    }
    return (hash ^ hash >> 15) % kSlots;
  }
  static constexpr std::size_t FirstLetter(std::string_view word) {
    return word.empty() ? 0 : static_cast<unsigned char>(word[0]) % 32;
  }
  static constexpr std::uint32_t LengthBit(std::string_view word) { return 1u << word.size() % 32; }
  static constexpr std::size_t NextSlot(std::size_t slot) { return (slot + 1) % kSlots; }

  std::array<std::string_view, N> words_;
  std::array<std::uint16_t, kSlots> slots_{};
  // The lengths of the words by first letter, in either case: one bit for each length modulo 32.
  std::array<std::uint32_t, 32> lengths_{};
};

}  // namespace clipc
