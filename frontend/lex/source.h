// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/span.h"
#include "frontend/lex/token.h"

// From text to tokens, and from a Span back to text. Clang's preprocessor, source manager and caret
// printer do the work; no name of Clang's appears here.
namespace clipc {

// What outlives one shader: the cache of files looked up, language options, target. A process that
// compiles many shaders keeps one per thread; a Source must not outlive its context, and one
// context serves one thread at a time. Files are expected not to appear or vanish while a context
// lives (look-ups are remembered); their contents may change.
class FrontendContext {
 public:
  FrontendContext();
  ~FrontendContext();
  FrontendContext(const FrontendContext&) = delete;
  FrontendContext& operator=(const FrontendContext&) = delete;

  struct State;
  State& state() { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

// What to read and how to preprocess it.
struct SourceInput {
  std::string path;  // a file, or "-": standard input; a label in messages when `text` is given
  std::optional<std::string>
      text;  // compile this instead of reading `path`; includes are looked up beside `path`
  std::vector<std::string> include_dirs;
  std::vector<std::string> defines;  // "NAME" (defined as 1) or "NAME=VALUE"
  int shader_model_major = 5;        // from 6 on, DXC's predefined macros are visible too
  int shader_model_minor = 0;
};

// A place for people and tools: file and line as #line says, 1-based; columns count bytes.
// `end_column` is one past the last byte of the phrase. A place inside a macro expansion is where
// the user wrote the macro's name or argument.
struct Place {
  std::string file;  // empty: nowhere
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::uint32_t end_line = 0;
  std::uint32_t end_column = 0;
};

// One translation unit: the main file and everything it includes. Spans handed out by its Lex are
// meaningful while it lives.
class Source {
 public:
  Source(FrontendContext& context, SourceInput input);
  ~Source();
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  // Empty Place for an empty span.
  Place Resolve(Span span) const;
  // The source line under a place is rendered as Clang does: include stack, message, line, caret as
  // wide as the span, fix-its, macro backtrace. Notes follow their diagnostic. `colour` adds
  // terminal escapes.
  std::string RenderText(const Diagnostics& diagnostics, bool colour) const;

  // Every file read, each once, in the order first entered; the main file first unless it is in
  // memory or "-".
  std::vector<std::string> Dependencies() const;
  // False when the main file could not be read at all (Lex has reported why).
  bool main_file_read() const;

  struct State;
  State& state() { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

// The whole token sequence after preprocessing, ended by one kEnd. Call it once per Source. Linear
// in the text read, and bounded: include cycles, macro bombs, deep nesting inside directives end in
// an error. After an error (see `diagnostics`) the sequence may be cut short and is not worth
// parsing.
Tokens Lex(Source& source, Diagnostics& diagnostics);

}  // namespace clipc
