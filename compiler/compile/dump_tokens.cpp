// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/dump_tokens.h"

#include <bit>
#include <iterator>

#include <fmt/format.h>

#include "clip-table/vocabulary.h"

namespace clipc {
namespace {

constexpr Named<LiteralKind> kLiteralKinds[] = {{LiteralKind::kBool, "bool"},
                                                {LiteralKind::kInt, "int"},
                                                {LiteralKind::kHexadecimal, "hexadecimal"},
                                                {LiteralKind::kUint, "uint"},
                                                {LiteralKind::kInt64, "int64"},
                                                {LiteralKind::kUint64, "uint64"},
                                                {LiteralKind::kHalf, "half"},
                                                {LiteralKind::kFloat, "float"},
                                                {LiteralKind::kTypedFloat, "float"},
                                                {LiteralKind::kDouble, "double"},
                                                {LiteralKind::kString, "string"}};

std::string Describe(const Token& token, const Names& names) {
  using enum TokenKind;
  switch (token.kind) {
    case kEnd: return "end";
    case kIdentifier: return fmt::format("identifier {}", names[token.name()]);
    case kIntLiteral:
      return fmt::format("{} {}", NameIn<kLiteralKinds>(token.literal), token.value);
    case kFloatLiteral:
      return fmt::format("{} {}", NameIn<kLiteralKinds>(token.literal),
                         std::bit_cast<double>(token.value));
    case kStringLiteral: return fmt::format("string \"{}\"", names[token.name()]);
    case kPragmaPackMatrix:
      return fmt::format("pack_matrix {}", token.value ? "row_major" : "column_major");
    case kUnknown: return "unknown";
    default: return std::string(SpellingOf(token.kind));
  }
}

}  // namespace

std::string DumpTokens(const Tokens& tokens, const Source& source) {
  std::string out, file;
  for (const Token& token : tokens.list) {
    const Place place = source.Resolve(token.span());
    if (!place.file.empty() && place.file != file) {
      file = place.file;
      out += fmt::format("{}:\n", file);
    }
    fmt::format_to(std::back_inserter(out), "{:>5}:{:<3} {}{}\n", place.line, place.column,
                   token.after_space ? "" : "~", Describe(token, tokens.names));
  }
  return out;
}

}  // namespace clipc
