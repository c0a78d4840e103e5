// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/lex/preprocess_guard.h"

namespace clipc {

void PreprocessGuard::Stop(Limit limit, std::uint32_t location) {
  if (stopped()) return;
  limit_ = limit;
  location_ = location;
}

void PreprocessGuard::Report(Diagnostics& diagnostics) const {
  const Span where{location_, location_};
  switch (limit_) {
    case Limit::kNone:
    case Limit::kReported: return;
    case Limit::kStack: diagnostics.Report(where, diag::DirectiveTooDeep); return;
    case Limit::kTokens:
      diagnostics.Report(where, diag::TooMuchToPreprocess, growth_, "tokens");
      return;
    case Limit::kExpansions:
      diagnostics.Report(where, diag::TooMuchToPreprocess, growth_, "macro expansions");
      return;
    case Limit::kIncludes:
      diagnostics.Report(where, diag::TooMuchToPreprocess, std::size_t{kMaxIncludes}, "includes");
      return;
    case Limit::kBytes:
      diagnostics.Report(where, diag::TooMuchToPreprocess, max_bytes_, "bytes of text");
      return;
    case Limit::kPasted:
      diagnostics.Report(where, diag::TooMuchToPreprocess, kMaxPasted, "bytes by `##`");
      return;
  }
}

}  // namespace clipc
