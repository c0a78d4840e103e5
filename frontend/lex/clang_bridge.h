// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "base/diagnostics.h"
#include "base/not_copied.h"
#include "base/span.h"
#include "frontend/lex/preprocess_guard.h"
#include "frontend/lex/source.h"

// The functions that the *_clang.cpp files, which alone include Clang, offer each other.

namespace clang {
class DiagnosticConsumer;
class DiagnosticOptions;
class LangOptions;
class MacroArgs;
class MacroInfo;
class IdentifierInfoLookup;
class PPCallbacks;
class Preprocessor;
class SourceLocation;
class SourceManager;
class Token;
}  // namespace clang

namespace clipc {

// The part of Clang's state that turns a Span into a place in the text.
struct ClangText {
  const clang::SourceManager& sources;
  const clang::LangOptions& language;
  clang::DiagnosticOptions& options;
};

Span SpanAt(const clang::SourceLocation& where);
Place Resolve(const ClangText& text, Span span);
std::vector<std::uint32_t> PlaceInText(const ClangText& text, Span span);
// Makes `line` the line of text that holds the beginning of `span`; it may already be that line.
void FindLine(const ClangText& text, Span span, TextLine& line);
std::optional<TextRange> InMainText(const ClangText& text, Span span);
std::optional<std::size_t> AfterInMainText(const ClangText& text, Span span);
std::string RenderText(const ClangText& text, const Diagnostics& diagnostics, bool colour);

// A consumer that puts what Clang's preprocessor reports into **diagnostics until `guard` stops it.
std::unique_ptr<clang::DiagnosticConsumer> ReportInto(Diagnostics* const* diagnostics,
                                                      const PreprocessGuard& guard,
                                                      std::function<void()> on_include_too_deep);

// Adds the pragmas of HLSL. `#pragma pack_matrix` becomes a token tok::annot_pragma_pack, whose
// annotation value is not null for row_major.
void AddPragmas(clang::Preprocessor& preprocessor, Diagnostics& diagnostics);

// A look-up for *preprocessor that adds Clang's own macros and calls AddPragmas at the first word
// of a shader that may need them. It does nothing while `preprocessor` is null.
std::unique_ptr<clang::IdentifierInfoLookup> AddMacrosAndPragmasOnFirstUse(
    clang::Preprocessor* const& preprocessor, Diagnostics& diagnostics);

// Callbacks that put the names of the macros that a text asks for into `used`: expanded, tested,
// defined or undefined. The definitions before the first line do not count.
std::unique_ptr<clang::PPCallbacks> RecordMacros(const clang::SourceManager& sources,
                                                 std::set<std::string>& used);

// The run of one preprocessor: during its life, `guard` counts every token that this thread reads.
class GuardScope : NotCopied {
 public:
  explicit GuardScope(PreprocessGuard& guard);
  ~GuardScope();

  // Reads a token as clang::Preprocessor::Lex does, which also looks for the modules of C++.
  void Read(clang::Preprocessor& preprocessor, clang::Token& token) const;

  PreprocessGuard& guard;

 private:
  const GuardScope* outer_;
};

// During its life, preprocessors of this thread read the operands of `##` in one way. At each use
// of a macro with `##`, `guard` counts the bytes that are pasted; where the operands are kept and
// fxc would expand them, there is a warning.
class PasteScope : NotCopied {
 public:
  PasteScope(PastedOperands how, PreprocessGuard& guard, Diagnostics& diagnostics);
  ~PasteScope();

  // Enters a macro in place of clang::Preprocessor::EnterMacro.
  void Enter(clang::Preprocessor& preprocessor, clang::Token& name, clang::SourceLocation end,
             clang::MacroInfo* macro, clang::MacroArgs* arguments);
  // Is called at the end of each macro.
  void EnableReplaced();

 private:
  struct State;
  std::unique_ptr<State> state_;
  PastedOperands how_;
  PreprocessGuard& guard_;
  Diagnostics& diagnostics_;
  PasteScope* outer_;
};

}  // namespace clipc
