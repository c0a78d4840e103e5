// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/token_digest.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace clipc {
namespace {

// Two hashes with a multiplication each: FNV-1a on words of eight bytes, and one with a rotation.
class Hash {
 public:
  void Add(std::uint64_t word) {
    first_ = (first_ ^ word) * 0x100000001b3;
    first_ ^= first_ >> 29;
    second_ = ((second_ << 25 | second_ >> 39) + word) * 0x9e3779b97f4a7c15;
    second_ ^= second_ >> 32;
  }
  void Add(std::string_view text) {
    Add(text.size());
    for (std::size_t at = 0; at < text.size(); at += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, text.data() + at, std::min<std::size_t>(8, text.size() - at));
      Add(word);
    }
  }
  TokenDigest Value() const { return {first_, second_}; }

 private:
  std::uint64_t first_ = 0xcbf29ce484222325, second_ = 0x2545f4914f6cdd1d;
};

}  // namespace

TokenDigest DigestOf(const Tokens& tokens) {
  Hash hash;
  for (const Token& token : tokens.list) {
    hash.Add(std::uint64_t{static_cast<std::uint8_t>(token.kind)} << 16 |
             std::uint64_t{static_cast<std::uint8_t>(token.literal)} << 8 |
             (token.after_space ? 1 : 0));
    hash.Add(token.value);
  }
  for (std::uint32_t i = 0; i < tokens.names.size(); ++i) hash.Add(tokens.names[Name{i}]);
  return hash.Value();
}

TokenDigest DigestOf(std::span<const std::string> texts) {
  Hash hash;
  for (const std::string& text : texts) hash.Add(text);
  return hash.Value();
}

}  // namespace clipc
