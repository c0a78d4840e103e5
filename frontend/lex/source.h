// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/span.h"
#include "base/stage.h"
#include "frontend/lex/token.h"

// The way from text to tokens, and from a Span back to text. Clang's preprocessor, source manager
// and caret printer do the work; no name of Clang's appears here.
namespace clipc {

// The state that several shaders share: the cache of files looked up, language options, target. A
// process that compiles many shaders keeps one for each thread; a Source must not outlive its
// context, and one context serves one thread at a time. Files must not appear or vanish during the
// life of a context (look-ups are remembered); their contents may change.
class FrontendContext {
 public:
  // The place where a context looks up include files. kNone, for sources whose includes come from
  // memory, looks up no file.
  enum class Files : std::uint8_t { kOnDisk, kNone };
  // Makes a context. If `sandbox` is not empty, only files in that folder are found, wherever a
  // path or a link to them lies.
  explicit FrontendContext(Files files = Files::kOnDisk, const std::string& sandbox = {});
  ~FrontendContext();
  FrontendContext(const FrontendContext&) = delete;
  FrontendContext& operator=(const FrontendContext&) = delete;

  struct State;
  State& state() { return *state_; }
  void Restart();  // forgets what was read

 private:
  std::unique_ptr<State> state_;
};

// The name and version of the library that the preprocessor is from, "LLVM 19.1.7".
std::string LlvmName();

// The versions of HLSL, which a shader sees as __HLSL_VERSION from shader model 6 on. dxc's default
// is 2021 since its version 1.7.
enum class LanguageVersion : std::uint16_t {
  k2016 = 2016,
  k2017 = 2017,
  k2018 = 2018,
  k2021 = 2021
};

// Whether a macro that is an operand of `##` is expanded before it is pasted, as fxc does, or kept,
// as in C and dxc.
enum class PastedOperands : std::uint8_t { kKept, kExpanded };

// A main file and how to preprocess it.
struct SourceInput {
  // The path of the main file, or "-" for standard input. If there is a `text`, its name in
  // messages.
  std::string path;
  // The text to compile instead of the file at `path`; its includes are looked up beside `path`.
  std::optional<std::string> text;
  std::vector<std::string> include_dirs;
  std::vector<std::string> defines;               // "NAME" (defined as 1) or "NAME=VALUE"
  std::string preamble = {};                      // text that is read after them
  std::vector<std::string> forced_includes = {};  // files, included before the first line
  // Returns the text of the include file at `path`, which is a folder, a slash and the name as
  // written, or none if there is no such file. For a context with Files::kNone only.
  std::function<std::optional<std::string>(const std::string& path)> read_include = {};
  int shader_model_major = 5;  // from 6 on, DXC's predefined macros are visible too
  int shader_model_minor = 0;
  // 3 for SPIR-V 1.3, where SPIR-V is what becomes of the text: DXC's macros for that are visible.
  std::optional<unsigned> spirv_minor = {};
  Stage stage = Stage::kVertex;
  LanguageVersion language = LanguageVersion::k2021;
  PastedOperands pasted = PastedOperands::kExpanded;
  // The limits past which there is an error: on the bytes of all files, counted each time that a
  // file is entered, and on the tokens that macros add to those of the files.
  std::size_t max_bytes = SIZE_MAX;
  std::size_t max_tokens = std::size_t{4} << 20;
  bool record_macros = false;  // whether to fill Source::MacrosUsed
};

// An include file that was entered, and the number of files that are open around it.
struct Include {
  std::string file;
  std::size_t depth = 0;
};

// A place for people and tools. File and line are as #line says; lines and columns count from 1,
// columns in bytes; `end_column` is one past the last byte of the phrase. A place inside a macro
// expansion is where the user wrote the macro's name or argument.
struct Place {
  std::string file;  // empty: there is no place
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::uint32_t end_line = 0;
  std::uint32_t end_column = 0;
  // The columns in Unicode code points; those above are in bytes.
  std::uint32_t character = 0;
  std::uint32_t end_character = 0;
};

// A line of text, without white space at its ends. Letters after the first kLongest are cut off.
struct TextLine {
  static constexpr std::size_t kLongest = 200;
  std::string file;  // as in Place; empty: there is no line
  std::uint32_t number = 0;
  std::string text;
  std::uint32_t begin = 0, end = 0;  // the locations of its first byte and of the one after it
};

// A part of a text, in bytes; `end` is one past the last.
struct TextRange {
  std::size_t begin = 0, end = 0;
};

// One translation unit: the main file and everything that it includes. The Spans of its tokens have
// a meaning during its life.
class Source {
 public:
  Source(FrontendContext& context, SourceInput input);
  ~Source();
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  // Returns the place of `span`, an empty one if the span is empty.
  Place Resolve(Span span) const;
  // Where the preprocessor reads the beginning of `span`, as numbers that compare as the places do:
  // in the main file, then in the includes around it, from outside. Empty if the span is.
  std::vector<std::uint32_t> PlaceInText(Span span) const;
  // The diagnostics as Clang prints its own: include stack, message, source line, caret as wide as
  // the span, fix-its, macro backtrace. Notes follow their diagnostic. `colour` adds the escape
  // sequences of a terminal.
  std::string RenderText(const Diagnostics& diagnostics, bool colour) const;

  // The files read, each once, in the order in which they were first entered. The main file is one
  // of them unless it is in memory or "-".
  std::vector<std::string> Dependencies() const;
  // The entries into include files, in order; a file that is entered twice is there twice.
  std::vector<Include> Includes() const;
  // The line that holds the beginning of `span`; it is valid until the next call. Asking for the
  // same line again costs nothing, however long it is.
  const TextLine& LineOf(Span span) const;
  // The names of the macros that the text asked for in any way, sorted; empty unless
  // SourceInput::record_macros is set. A macro that was defined before the first line and is not
  // among them had no part in the tokens and messages.
  std::vector<std::string> MacrosUsed() const;
  // Whether the main file could be read; Lex reports it if not.
  bool main_file_read() const;

  // The text of the main file, as UTF-8.
  const std::string& MainText() const;
  // The bytes of it that spell `span`; none if a macro or an include has a part of the span.
  std::optional<TextRange> InMainText(Span span) const;
  // The byte of it after `span`: after the use of a macro that makes the end of the span, or after
  // the line of the include that has it. None for text that the main file does not ask for.
  std::optional<std::size_t> AfterInMainText(Span span) const;

  struct State;
  State& state() { return *state_; }
  void Restart();  // forgets what was read

 private:
  std::unique_ptr<State> state_;
};

// Preprocesses a source; the tokens end in one kEnd. Call it once for each Source. It is linear in
// the text read, and bounded: include cycles, macros that grow without end and deep nesting inside
// directives are errors. After an error the sequence may be cut short and is not worth parsing.
//
// With the name of an `entry`, the bodies of functions that it does not reach are left out: `{`
// is followed by `}`. A function is reached by its name, which is a word outside of bodies or of
// the body of a function that is reached. Nothing is reported of what is left out.
Tokens Lex(Source& source, Diagnostics& diagnostics, std::string_view entry = {});

// Returns the text after preprocessing, for people and other compilers: with the lines where they
// were, and #line where a file begins or many lines are left out. It is called instead of Lex, and
// has the same limits.
std::string Preprocess(Source& source, Diagnostics& diagnostics);

}  // namespace clipc
