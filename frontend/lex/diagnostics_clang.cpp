// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Conversion of places and messages: the diagnostics of Clang's preprocessor become clipc's, and
// Clang's printer draws clipc's.
#include <algorithm>
#include <cstring>
#include <utility>

#include <clang/Basic/Diagnostic.h>
#include <clang/Basic/DiagnosticOptions.h>
#include <clang/Basic/LangOptions.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Basic/Version.inc>
#include <clang/Frontend/TextDiagnostic.h>
#include <clang/Lex/LexDiagnostic.h>
#include <clang/Lex/Lexer.h>
#include <llvm/ADT/SmallString.h>
#include <llvm/ADT/StringSet.h>
#include <llvm/Support/Path.h>
#include <llvm/Support/raw_ostream.h>

#include "frontend/lex/clang_bridge.h"

namespace clipc {
namespace {

using clang::CharSourceRange;
using clang::FixItHint;
using clang::SourceLocation;

SourceLocation Location(std::uint32_t raw) { return SourceLocation::getFromRawEncoding(raw); }
Span ToSpan(SourceLocation begin, SourceLocation end) {
  return {begin.getRawEncoding(), end.getRawEncoding()};
}

class Consumer : public clang::DiagnosticConsumer {
 public:
  Consumer(Diagnostics* const* diagnostics, const PreprocessGuard& guard,
           std::function<void()> on_include_too_deep)
      : diagnostics_(diagnostics),
        guard_(guard),
        on_include_too_deep_(std::move(on_include_too_deep)) {}

  void HandleDiagnostic(clang::DiagnosticsEngine::Level level,
                        const clang::Diagnostic& info) override {
    if (guard_.stopped() || level == clang::DiagnosticsEngine::Ignored) return;
    if (info.getID() == clang::diag::err_pp_include_too_deep) return on_include_too_deep_();
    // `#pragma once` is right in an include file that is compiled by itself.
    if (info.getID() == clang::diag::pp_pragma_once_in_main_file) return;
    if (info.getID() == clang::diag::err_invalid_utf8 && std::exchange(is_not_text_, true)) return;
    const Span where = SpanAt(info.getLocation());
    if (info.getID() == clang::diag::pp_nonportable_path) return ReportSpelling(where, info);
    llvm::SmallString<128> message;
    info.FormatDiagnostic(message);
    if (level == clang::DiagnosticsEngine::Note) {
      if (last_) last_->Note(where, diag::PreprocessorNote, message.str());
      return;
    }
    if (info.getID() == clang::diag::err_pp_invalid_directive && IsVersion(info))
      message += "; `#version` is GLSL's, and clipc reads HLSL";
    last_ = &Report(level, info.getID(), where, message.str());
    for (const CharSourceRange& range : info.getRanges()) {
      if (range.isTokenRange()) last_->also.push_back(ToSpan(range.getBegin(), range.getEnd()));
    }
    for (const FixItHint& hint : info.getFixItHints()) AddFixIt(hint);
  }

 private:
  // Whether the directive is `#version`, GLSL's first line.
  static bool IsVersion(const clang::Diagnostic& info) {
    const char* const name = info.getSourceManager().getCharacterData(info.getLocation());
    return llvm::StringRef(name).starts_with("version");
  }

  // Warns, once for each name, about a file that was found by a name in another case, as Windows
  // finds it.
  void ReportSpelling(Span where, const clang::Diagnostic& info) {
    const llvm::StringRef on_disk = llvm::StringRef(info.getArgStdStr(0)).drop_front().drop_back();
    const char* const quote = info.getSourceManager().getCharacterData(info.getLocation());
    const llvm::StringRef name(quote + 1, *quote ? strnlen(quote + 1, on_disk.size()) : 0);
    if (!name.equals_insensitive(on_disk) || !misspelled_.insert(name).second) return;
    const std::string portable = llvm::sys::path::convert_to_slash(on_disk);
    last_ = &(**diagnostics_).Report(where, diag::IncludeSpelling, name.str(), portable);
  }

  Diagnostic& Report(clang::DiagnosticsEngine::Level level, unsigned id, Span where,
                     std::string_view message) {
    Diagnostics& to = **diagnostics_;
    switch (id) {
      case clang::diag::ext_pp_macro_redef: return to.Report(where, diag::MacroRedefined, message);
      case clang::diag::err_pp_hash_error: return to.Report(where, diag::ErrorDirective, message);
      case clang::diag::pp_hash_warning: return to.Report(where, diag::WarningDirective, message);
      // Clang's extension, which fxc and dxc do not have.
      case clang::diag::ext_pp_embed_directive:
        return to.Report(where, diag::PreprocessorError, "`#embed` is not HLSL");
      case clang::diag::warn_pragma_message: return to.Report(where, diag::PragmaMessage, message);
      default: break;
    }
    return level >= clang::DiagnosticsEngine::Error
               ? to.Report(where, diag::PreprocessorError, message)
               : to.Report(where, diag::PreprocessorWarning, message);
  }

  void AddFixIt(const FixItHint& hint) {
    if (!hint.InsertFromRange.isInvalid()) return;
    if (hint.RemoveRange.isTokenRange()) {
      last_->Fix(ToSpan(hint.RemoveRange.getBegin(), hint.RemoveRange.getEnd()), hint.CodeToInsert);
    } else if (hint.RemoveRange.getBegin() == hint.RemoveRange.getEnd()) {
      last_->fix_its.push_back({SpanAt(hint.RemoveRange.getBegin()), hint.CodeToInsert, true});
    }
  }

  Diagnostics* const* diagnostics_;
  const PreprocessGuard& guard_;
  llvm::StringSet<> misspelled_;
  std::function<void()> on_include_too_deep_;
  bool is_not_text_ = false;
  Diagnostic* last_ = nullptr;  // valid for its notes, which follow it at once
};

// The place in a file of a location that may be in a macro: where the user wrote the macro's
// argument, otherwise one end of the macro's use.
SourceLocation FileEnd(const clang::SourceManager& sources, SourceLocation location,
                       bool is_begin) {
  while (location.isMacroID()) {
    if (sources.isMacroArgExpansion(location)) {
      location = sources.getImmediateSpellingLoc(location);
    } else {
      const CharSourceRange use = sources.getImmediateExpansionRange(location);
      location = is_begin ? use.getBegin() : use.getEnd();
    }
  }
  return location;
}

// The bytes of `span`, as the user wrote them where a macro is involved; only those of its first
// token if it starts and ends in different files.
CharSourceRange FileRange(const ClangText& text, Span span) {
  const SourceLocation begin = FileEnd(text.sources, Location(span.begin), true);
  const SourceLocation end = FileEnd(text.sources, Location(span.end), false);
  const bool is_in_order = text.sources.isWrittenInSameFile(begin, end) &&
                           text.sources.getFileOffset(begin) <= text.sources.getFileOffset(end);
  return clang::Lexer::getAsCharRange(clang::SourceRange(begin, is_in_order ? end : begin),
                                      text.sources, text.language);
}

clang::DiagnosticsEngine::Level LevelOf(Severity severity) {
  switch (severity) {
    case Severity::kNote: return clang::DiagnosticsEngine::Note;
    case Severity::kWarning: return clang::DiagnosticsEngine::Warning;
    case Severity::kError: break;
  }
  return clang::DiagnosticsEngine::Error;
}

std::vector<FixItHint> Hints(const Diagnostic& diagnostic) {
  std::vector<FixItHint> hints;
  for (const FixIt& fix : diagnostic.fix_its) {
    const auto range =
        CharSourceRange::getTokenRange(Location(fix.span.begin), Location(fix.span.end));
    hints.push_back(fix.insert ? FixItHint::CreateInsertion(range.getBegin(), fix.text)
                               : FixItHint::CreateReplacement(range, fix.text));
  }
  return hints;
}

// Clang's printer. It passes over the letters of a line several times, at the cost of a small
// shader: the usual line is drawn here in the same way, one of plain letters that has all of the
// ranges, without colours and fix-its.
class Printer : public clang::TextDiagnostic {
 public:
  template <typename Options>
  Printer(llvm::raw_ostream& out, const ClangText& text, Options&& options)
      : TextDiagnostic(out, text.language, options), out_(out), text_(text) {}

 private:
  using Ranges = llvm::SmallVectorImpl<CharSourceRange>;

  void emitCodeContext(clang::FullSourceLoc where, clang::DiagnosticsEngine::Level level,
                       Ranges& ranges, llvm::ArrayRef<FixItHint> hints) override {
    if (text_.options.ShowColors || ranges.empty() || !hints.empty() || !DrawLine(where, ranges))
      TextDiagnostic::emitCodeContext(where, level, ranges, hints);
  }

  // Returns whether the line is a usual one, and was drawn.
  bool DrawLine(const clang::FullSourceLoc& where, const Ranges& ranges) {
    constexpr std::size_t kLongest = 4096;
    const auto [file, offset] = where.getDecomposedLoc();
    const llvm::StringRef all = text_.sources.getBufferData(file);
    const std::size_t begin = all.rfind('\n', offset) + 1;  // npos + 1 is 0
    const llvm::StringRef line = all.slice(begin, all.find_first_of("\r\n", offset));
    const auto is_plain = [](char c) { return c >= ' ' && c <= '~'; };
    if (offset >= all.size() || line.size() > kLongest || !llvm::all_of(line, is_plain))
      return false;
    std::string carets(line.size() + 1, ' ');
    for (const CharSourceRange& range : ranges) {
      const auto [first_file, first] = text_.sources.getDecomposedLoc(range.getBegin());
      auto [last_file, last] = text_.sources.getDecomposedLoc(range.getEnd());
      if (range.isTokenRange())
        last += clang::Lexer::MeasureTokenLength(range.getEnd(), text_.sources, text_.language);
      const bool is_in_line = first_file == file && last_file == file && begin <= first &&
                              first <= last && last <= begin + line.size();
      if (!range.getBegin().isFileID() || !range.getEnd().isFileID() || !is_in_line) return false;
      std::fill(carets.begin() + (first - begin), carets.begin() + (last - begin), '~');
    }
    carets[offset - begin] = '^';
    const unsigned number = where.getPresumedLoc().getLine();
    const auto digits = [](unsigned of) { return std::to_string(of).size(); };
    // Clang makes room for all the lines that it may draw.
    const auto width = static_cast<unsigned>(
        std::max<std::size_t>(4, digits(number + text_.options.SnippetLineLimit)));
    out_.indent(width + 1 - static_cast<unsigned>(digits(number))) << number << " | " << line;
    out_ << '\n';
    out_.indent(width + 2) << "| " << llvm::StringRef(carets).rtrim() << '\n';
    return true;
  }

  llvm::raw_ostream& out_;
  const ClangText& text_;
};

void Draw(const ClangText& text, clang::TextDiagnostic& printer, llvm::raw_ostream& out,
          const Diagnostic& diagnostic) {
  const std::string message = diagnostic.message + MessageSuffix(diagnostic);
  if (diagnostic.span) {
    std::vector<CharSourceRange> ranges{CharSourceRange::getTokenRange(
        Location(diagnostic.span.begin), Location(diagnostic.span.end))};
    for (Span also : diagnostic.also) {
      ranges.push_back(CharSourceRange::getTokenRange(Location(also.begin), Location(also.end)));
    }
    printer.emitDiagnostic(clang::FullSourceLoc(Location(diagnostic.span.begin), text.sources),
                           LevelOf(diagnostic.severity), message, ranges, Hints(diagnostic));
  } else {
    const bool colour = text.options.ShowColors;
    out << "clipc: ";
    clang::TextDiagnostic::printDiagnosticLevel(out, LevelOf(diagnostic.severity), colour);
    clang::TextDiagnostic::printDiagnosticMessage(out, diagnostic.severity == Severity::kNote,
                                                  message, 0, 0, colour);
  }
  for (const Diagnostic& note : diagnostic.notes) Draw(text, printer, out, note);
}

}  // namespace

Span SpanAt(const SourceLocation& where) { return ToSpan(where, where); }

// The column in Unicode code points, which is not greater than that in bytes.
static std::uint32_t CharacterOf(const clang::SourceManager& sources, SourceLocation at,
                                 std::uint32_t column) {
  const auto [file, offset] = sources.getDecomposedLoc(at);
  const llvm::StringRef before =
      sources.getBufferData(file).substr(offset - std::min(offset, column - 1), column - 1);
  const auto rest = std::ranges::count_if(before, [](char c) { return (c & 0xC0) == 0x80; });
  return column - static_cast<std::uint32_t>(rest);
}

Place Resolve(const ClangText& text, Span span) {
  if (!span) return {};
  const CharSourceRange range = FileRange(text, span);
  const clang::PresumedLoc begin = text.sources.getPresumedLoc(range.getBegin());
  const clang::PresumedLoc end = text.sources.getPresumedLoc(range.getEnd());
  if (begin.isInvalid() || end.isInvalid()) return {};
  return {begin.getFilename(),
          begin.getLine(),
          begin.getColumn(),
          end.getLine(),
          end.getColumn(),
          CharacterOf(text.sources, range.getBegin(), begin.getColumn()),
          CharacterOf(text.sources, range.getEnd(), end.getColumn())};
}

std::vector<std::uint32_t> PlaceInText(const ClangText& text, Span span) {
  std::vector<std::uint32_t> place;
  if (!span) return place;
  clang::FileID outermost;
  for (SourceLocation at = FileRange(text, span).getBegin(); at.isValid();
       at = text.sources.getIncludeLoc(outermost)) {
    const auto [file, offset] = text.sources.getDecomposedLoc(at);
    place.push_back(offset + 1);
    outermost = file;
  }
  // -include and -D come before the main file.
  if (outermost != text.sources.getMainFileID()) place.push_back(0);
  std::ranges::reverse(place);
  return place;
}

void FindLine(const ClangText& text, Span span, TextLine& line) {
  const SourceLocation where = FileEnd(text.sources, Location(span.begin), true);
  if (span && where.getRawEncoding() >= line.begin && where.getRawEncoding() < line.end) return;
  line = {};
  const clang::PresumedLoc place = span ? text.sources.getPresumedLoc(where) : clang::PresumedLoc();
  if (place.isInvalid()) return;
  const auto [file, offset] = text.sources.getDecomposedLoc(where);
  const llvm::StringRef all = text.sources.getBufferData(file);
  const std::size_t start = all.rfind('\n', offset) + 1;  // npos + 1 is 0
  const std::size_t end = std::min(all.find_first_of("\r\n", offset), all.size());
  const std::uint32_t begin = where.getRawEncoding() - (offset - static_cast<unsigned>(start));
  line = {place.getFilename(), place.getLine(),
          all.slice(start, end).trim().take_front(TextLine::kLongest).str(), begin,
          begin + static_cast<std::uint32_t>(end - start)};
}

std::string RenderText(const ClangText& text, const Diagnostics& diagnostics, bool colour) {
  std::string rendered;
  llvm::raw_string_ostream out(rendered);
  out.enable_colors(colour);
  text.options.ShowColors = colour;
  text.options.ShowPresumedLoc = true;  // messages obey #line
#if CLANG_VERSION_MAJOR >= 21
  Printer printer(out, text, text.options);
#else
  Printer printer(out, text, &text.options);
#endif
  for (const Diagnostic& diagnostic : diagnostics.all()) Draw(text, printer, out, diagnostic);
  out.flush();
  return rendered;
}

std::unique_ptr<clang::DiagnosticConsumer> ReportInto(Diagnostics* const* diagnostics,
                                                      const PreprocessGuard& guard,
                                                      std::function<void()> on_include_too_deep) {
  return std::make_unique<Consumer>(diagnostics, guard, std::move(on_include_too_deep));
}

}  // namespace clipc
