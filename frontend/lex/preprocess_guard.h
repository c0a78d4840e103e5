// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "base/diagnostics.h"

namespace clipc {

// Keeps hostile text from running away inside one call of the preprocessor: nested macro arguments
// and `#if (((...` recurse, macros and includes can grow without bound before a token comes out.
// Once stopped, the preprocessor is shown the end of everything.
class PreprocessGuard {
 public:
  enum class Limit : std::uint8_t { kNone, kStack, kTokens, kExpansions, kIncludes, kReported };

  bool stopped() const { return limit_ != Limit::kNone; }
  // kReported: a diagnostic has said why.
  void Stop(Limit limit, std::uint32_t location);
  // Says which limit was met, unless that was said.
  void Report(Diagnostics& diagnostics) const;

  // What is deeper in the stack by kMaxStack stops.
  void SetStackBase(const char* base) { stack_base_ = base; }

  // Counts one token that Clang reads, its own look-ahead included; kNone or the limit that is
  // passed. The caller stops.
  Limit CountToken() {
    // Not the address of a variable: AddressSanitizer may keep those elsewhere.
    const auto* here = static_cast<const char*>(__builtin_frame_address(0));
    if (static_cast<std::size_t>(std::abs(stack_base_ - here)) > kMaxStack) return Limit::kStack;
    return ++tokens_ > max_tokens_ ? Limit::kTokens : Limit::kNone;
  }
  void CountExpansion(std::uint32_t location) {
    if (++expansions_ > max_tokens_) Stop(Limit::kExpansions, location);
  }
  // A file of that many bytes is entered: it has at most that many tokens.
  void CountInclude(std::uint32_t location, std::size_t bytes) {
    max_tokens_ += bytes;
    if (++includes_ > kMaxIncludes) Stop(Limit::kIncludes, location);
  }

 private:
  static constexpr std::size_t kMaxStack = std::size_t{2} << 20;
  static constexpr std::size_t kMaxGrowth = std::size_t{1}
                                            << 22;  // tokens that macros add to what is written
  static constexpr unsigned kMaxIncludes = 1u << 16;

  const char* stack_base_ = nullptr;
  std::size_t max_tokens_ = kMaxGrowth;
  std::size_t tokens_ = 0;
  std::size_t expansions_ = 0;
  unsigned includes_ = 0;
  Limit limit_ = Limit::kNone;
  std::uint32_t location_ = 0;
};

}  // namespace clipc
