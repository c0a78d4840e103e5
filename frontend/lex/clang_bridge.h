// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/diagnostics.h"
#include "base/span.h"
#include "frontend/lex/preprocess_guard.h"
#include "frontend/lex/source.h"

// What the files that include Clang say to each other, in terms that do not.

namespace clang {
class DiagnosticConsumer;
class DiagnosticOptions;
class LangOptions;
class Preprocessor;
class SourceManager;
}  // namespace clang

namespace clipc {

// Everything needed to show a place in the text.
struct ClangText {
  const clang::SourceManager& sources;
  const clang::LangOptions& language;
  clang::DiagnosticOptions& options;
};

Place Resolve(const ClangText& text, Span span);
std::string RenderText(const ClangText& text, const Diagnostics& diagnostics, bool colour);

// What Clang's preprocessor reports is put into *diagnostics, until `guard` has stopped it.
std::unique_ptr<clang::DiagnosticConsumer> ReportInto(Diagnostics* const* diagnostics,
                                                      const PreprocessGuard& guard,
                                                      std::function<void()> on_include_too_deep);

// Adds what HLSL knows after `#pragma`. `#pragma pack_matrix` becomes a token
// tok::annot_pragma_pack, whose value is not null for row_major.
void AddPragmas(clang::Preprocessor& preprocessor, Diagnostics& diagnostics);

}  // namespace clipc
