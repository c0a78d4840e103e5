// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <clang/Basic/SourceManager.h>
#include <clang/Lex/Lexer.h>

#include "frontend/lex/clang_bridge.h"

namespace clipc {
namespace {

using clang::SourceLocation;

SourceLocation LocationOf(std::uint32_t number) {
  return SourceLocation::getFromRawEncoding(number);
}

std::size_t AfterToken(const ClangText& text, SourceLocation token) {
  return text.sources.getFileOffset(token) +
         clang::Lexer::MeasureTokenLength(token, text.sources, text.language);
}

}  // namespace

std::optional<TextRange> InMainText(const ClangText& text, Span span) {
  const SourceLocation begin = LocationOf(span.begin), end = LocationOf(span.end);
  const auto is_spelt = [&](SourceLocation place) {
    return place.isFileID() && text.sources.getFileID(place) == text.sources.getMainFileID();
  };
  if (!span || !is_spelt(begin) || !is_spelt(end)) return std::nullopt;
  return TextRange{text.sources.getFileOffset(begin), AfterToken(text, end)};
}

std::optional<std::size_t> AfterInMainText(const ClangText& text, Span span) {
  if (!span) return std::nullopt;
  SourceLocation place = text.sources.getExpansionRange(LocationOf(span.end)).getEnd();
  const clang::FileID main = text.sources.getMainFileID();
  if (text.sources.getFileID(place) == main) return AfterToken(text, place);
  while (place.isValid() && text.sources.getFileID(place) != main)
    place = text.sources.getIncludeLoc(text.sources.getFileID(place));
  if (place.isInvalid()) return std::nullopt;
  const llvm::StringRef all = text.sources.getBufferData(main);
  const std::size_t line_end = all.find('\n', text.sources.getFileOffset(place));
  return line_end == llvm::StringRef::npos ? all.size() : line_end + 1;
}

}  // namespace clipc
