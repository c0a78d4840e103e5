// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/dump_tokens.h"

#include <bit>
#include <iterator>

#include <fmt/format.h>

namespace clipc {
namespace {

const char* NameOf(LiteralKind kind) {
  switch (kind) {
    case LiteralKind::kBool: return "bool";
    case LiteralKind::kInt: return "int";
    case LiteralKind::kUint: return "uint";
    case LiteralKind::kInt64: return "int64";
    case LiteralKind::kUint64: return "uint64";
    case LiteralKind::kHalf: return "half";
    case LiteralKind::kFloat: return "float";
    case LiteralKind::kDouble: return "double";
    case LiteralKind::kString: return "string";
  }
  return "";
}

std::string Describe(const Token& token, const Names& names) {
  switch (token.kind) {
    case TokenKind::kEnd: return "end";
    case TokenKind::kIdentifier: return fmt::format("identifier {}", names[token.name()]);
    case TokenKind::kIntLiteral: return fmt::format("{} {}", NameOf(token.literal), token.value);
    case TokenKind::kFloatLiteral:
      return fmt::format("{} {}", NameOf(token.literal), std::bit_cast<double>(token.value));
    case TokenKind::kStringLiteral: return fmt::format("string \"{}\"", names[token.name()]);
    case TokenKind::kPragmaPackMatrix:
      return fmt::format("pack_matrix {}", token.value ? "row_major" : "column_major");
    case TokenKind::kUnknown: return "unknown";
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
