// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "base/diagnostics.h"

namespace clipc {

// Bounds the work of one call of Clang's preprocessor on hostile text: nested macro arguments and
// `#if (((...` recurse, macros and includes can grow without bound before a token comes out. From
// Stop on, the preprocessor reads the end of all files.
class PreprocessGuard {
 public:
  enum class Limit : std::uint8_t {
    kNone,
    kStack,
    kTokens,
    kExpansions,
    kIncludes,
    kBytes,
    kPasted,
    kReported
  };

  bool stopped() const { return limit_ != Limit::kNone; }
  // `limit` is kReported if a diagnostic has given the reason.
  void Stop(Limit limit, std::uint32_t location);
  // Reports the limit that was passed, unless it is kReported.
  void Report(Diagnostics& diagnostics) const;

  // Sets the limits on the bytes of all files, counted each time that a file is entered, and on the
  // tokens that macros may add to those of the files.
  void SetLimits(std::size_t bytes, std::size_t growth) {
    max_bytes_ = bytes;
    max_tokens_ = growth_ = growth;
  }

  // Sets `base`, the place in the stack from which tokens may be read at most kMaxStack bytes
  // deeper.
  void SetStackBase(const char* base) { stack_base_ = base; }

  // Counts one token that Clang reads, for itself or for clipc. Returns the limit that it passes,
  // or kNone; the caller calls Stop.
  Limit CountToken() { return ++tokens_ > max_tokens_ ? Limit::kTokens : Limit::kNone; }
  // Counts tokens that Clang did not read, which are no more than the bytes of their file.
  void CountTokens(std::size_t count) { tokens_ += count; }
  // The same for a token that Clang reads for itself, at any depth.
  Limit CountInnerToken() {
    // The address of a variable would not do: AddressSanitizer may keep variables elsewhere.
    const auto* here = static_cast<const char*>(__builtin_frame_address(0));
    if (static_cast<std::size_t>(std::abs(stack_base_ - here)) > kMaxStack) return Limit::kStack;
    return CountToken();
  }
  void CountExpansion(std::uint32_t location) {
    if (++expansions_ > max_tokens_) Stop(Limit::kExpansions, location);
  }
  // Counts `bytes` bytes that `##` makes, before it makes them.
  void CountPasting(std::uint32_t location, std::size_t bytes) {
    pasted_ += bytes;
    if (pasted_ > kMaxPasted) Stop(Limit::kPasted, location);
  }
  // Counts an entered file of `bytes` bytes, which has at most that many tokens.
  void CountInclude(std::uint32_t location, std::size_t bytes) {
    max_tokens_ += bytes;
    bytes_ += bytes;
    if (bytes_ > max_bytes_) Stop(Limit::kBytes, location);
    if (++includes_ > kMaxIncludes) Stop(Limit::kIncludes, location);
  }

 private:
#ifdef __wasm__
  // Calls in WebAssembly also use a stack of the host, which is not seen here: about 1 MiB in V8.
  static constexpr std::size_t kMaxStack = std::size_t{256} << 10;
#else
  static constexpr std::size_t kMaxStack = std::size_t{2} << 20;
#endif
  static constexpr unsigned kMaxIncludes = 1u << 16;
  static constexpr std::size_t kMaxPasted = std::size_t{64} << 20;

  const char* stack_base_ = nullptr;
  std::size_t max_bytes_ = SIZE_MAX, bytes_ = 0;
  std::size_t growth_ = 0;
  std::size_t max_tokens_ = 0;  // growth_, and what the files may have
  std::size_t tokens_ = 0;
  std::size_t expansions_ = 0;
  std::size_t pasted_ = 0;
  unsigned includes_ = 0;
  Limit limit_ = Limit::kNone;
  std::uint32_t location_ = 0;
};

}  // namespace clipc
