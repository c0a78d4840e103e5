// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/preprocess_guard.h"

#include <cstdlib>

namespace clipc {

void PreprocessGuard::Stop(Limit limit, std::uint32_t location) {
  if (stopped()) return;
  limit_ = limit;
  location_ = location;
}

PreprocessGuard::Limit PreprocessGuard::CountToken() {
  // Not the address of a variable: AddressSanitizer may keep those elsewhere.
  const auto* here = static_cast<const char*>(__builtin_frame_address(0));
  if (static_cast<std::size_t>(std::abs(stack_base_ - here)) > kMaxStack) return Limit::kStack;
  return ++tokens_ > max_tokens_ ? Limit::kTokens : Limit::kNone;
}

void PreprocessGuard::Report(Diagnostics& diagnostics) const {
  const Span where{location_, location_};
  switch (limit_) {
    case Limit::kNone:
    case Limit::kReported: return;
    case Limit::kStack: diagnostics.Report(where, diag::DirectiveTooDeep); return;
    case Limit::kTokens: diagnostics.Report(where, diag::TooMuchToPreprocess, max_tokens_, "tokens"); return;
    case Limit::kExpansions:
      diagnostics.Report(where, diag::TooMuchToPreprocess, max_tokens_, "macro expansions");
      return;
    case Limit::kIncludes: diagnostics.Report(where, diag::TooMuchToPreprocess, std::size_t{kMaxIncludes}, "includes"); return;
  }
}

}  // namespace clipc
