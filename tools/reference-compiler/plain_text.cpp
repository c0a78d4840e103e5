// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/reference-compiler/plain_text.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <set>
#include <utility>
#include <vector>

#include "base/spelling.h"

namespace clipc::draw::reference_compiler {
namespace {

using enum TokenKind;
using Item = KeptVector<Token>;  // one declaration

class Writer {
 public:
  Writer(const Tokens& tokens, const std::string& entry) : names_(tokens.names) {
    Split(WithoutAnnotations(tokens.list));
    reached_.insert(entry);
  }

  std::string Run() {
    for (Item& item : items_) Reduce(item);
    for (const Item& item : items_) {
      if (FunctionName(item).empty()) Reach(item);
    }
    for (std::size_t before = 0; before != reached_.size();) {
      before = reached_.size();
      for (const Item& item : items_) {
        if (reached_.contains(FunctionName(item))) Reach(item);
      }
    }
    std::string text;
    for (const Item& item : items_) {
      const std::string name = FunctionName(item);
      if (!name.empty() && !reached_.contains(name)) continue;
      for (const Token& token : item) text += Spelling(token) + ' ';
      text += '\n';
    }
    return text;
  }

 private:
  // name < string UIName = "..."; >
  static KeptVector<Token> WithoutAnnotations(const KeptVector<Token>& tokens) {
    KeptVector<Token> kept;
    int depth = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      depth += BracketStep(tokens[i].kind);
      const auto kind = [&](std::size_t ahead) {
        return i + ahead < tokens.size() ? tokens[i + ahead].kind : kEnd;
      };
      const bool is_value = kind(3) == kEqual || kind(3) == kLeftBracket;
      const bool begins =
          depth == 0 && kind(0) == kLess &&
          (kind(1) == kGreater || (kind(1) == kIdentifier && kind(2) == kIdentifier && is_value));
      if (!begins) {
        kept.push_back(tokens[i]);
        continue;
      }
      while (kind(0) != kEnd && !(kind(0) == kGreater && (tokens[i - 1].kind == kSemicolon ||
                                                          tokens[i - 1].kind == kLess)))
        ++i;
    }
    return kept;
  }

  // A declaration ends with a semicolon outside of brackets, or with a brace that no semicolon
  // follows.
  void Split(const KeptVector<Token>& tokens) {
    Item item;
    int depth = 0;
    for (std::size_t i = 0; i < tokens.size() && tokens[i].kind != kEnd; ++i) {
      if (tokens[i].kind == kPragmaPackMatrix && item.empty()) {
        items_.push_back({tokens[i]});
        continue;
      }
      item.push_back(tokens[i]);
      depth += BracketStep(tokens[i].kind);
      const TokenKind next = tokens[i + 1].kind;
      const bool closes =
          tokens[i].kind == kRightBrace && next != kSemicolon &&
          (next == kIdentifier || next == kLeftBracket || next == kEnd) &&
          !DeclaresVariable(item, tokens[i + 1], i + 2 < tokens.size() ? tokens[i + 2].kind : kEnd);
      if (depth == 0 && (tokens[i].kind == kSemicolon || closes))
        items_.push_back(std::exchange(item, {}));
    }
    if (!item.empty()) items_.push_back(std::move(item));
  }

  // struct S { ... } variable;
  bool DeclaresVariable(const Item& item, const Token& name, TokenKind next) const {
    const std::string_view first = Text(item.front());
    const bool has_type = first == "struct" || first == "class" || first == "static" ||
                          first == "const" || first == "uniform";
    return has_type && name.kind == kIdentifier &&
           (next == kSemicolon || next == kComma || next == kEqual || next == kLeftBracket);
  }

  std::string_view Text(const Token& token) const {
    return token.kind == kIdentifier ? names_[token.name()] : std::string_view();
  }

  // Removes the parts that only an effect has.
  void Reduce(Item& item) {
    static const std::set<std::string_view> kDropped = {
        "VertexShader",    "PixelShader",      "GeometryShader",   "HullShader",
        "DomainShader",    "ComputeShader",    "BlendState",       "DepthStencilState",
        "RasterizerState", "RenderTargetView", "DepthStencilView", "stateblock",
        "string"};
    const std::string_view first = Text(item.front());
    if (ToLower(first.substr(0, 9)) == "technique" || first.starts_with("texture") ||
        first == "fxgroup" || kDropped.contains(first))
      return item.clear();
    DropState(item);
  }

  // SamplerState s { Filter = ...; };   sampler s = sampler_state { ... };
  void DropState(Item& item) {
    if (item.empty()) return;
    const std::string_view first = Text(item.front());
    if (!first.starts_with("sampler") && !first.starts_with("Sampler")) return;
    const auto is_state = [&](const Token& token) {
      return token.kind == kLeftBrace || token.kind == kEqual;
    };
    const auto begin = std::ranges::find_if(item, is_state);
    if (begin == item.end()) return;
    Token semicolon = item.back();
    semicolon.kind = kSemicolon;
    item.erase(begin, item.end());
    item.push_back(semicolon);
  }

  // The name of the function; empty where the item is not a function with a body.
  std::string FunctionName(const Item& item) const {
    if (item.empty() || item.back().kind != kRightBrace) return "";
    static const std::set<std::string_view> kOthers = {
        "struct", "class", "cbuffer", "tbuffer", "namespace", "interface", "enum", "typedef"};
    if (kOthers.contains(Text(item.front()))) return "";
    int depth = 0;
    for (std::size_t i = 0; i < item.size(); ++i) {
      if (depth == 0 && item[i].kind == kLeftParen && i > 0 && item[i - 1].kind == kIdentifier)
        return std::string(Text(item[i - 1]));
      depth += BracketStep(item[i].kind);
    }
    return "";
  }

  void Reach(const Item& item) {
    for (const Token& token : item) {
      if (token.kind == kIdentifier) reached_.emplace(Text(token));
    }
  }

  std::string Spelling(const Token& token) const {
    char text[64];
    switch (token.kind) {
      case kIdentifier: return std::string(Text(token));
      case kStringLiteral: return "\"" + std::string(names_[token.name()]) + "\"";
      case kPragmaPackMatrix:
        return std::string("\n#pragma pack_matrix(") +
               (token.value ? "row_major" : "column_major") + ")\n";
      case kIntLiteral:
        if (token.literal == LiteralKind::kBool) return token.value ? "true" : "false";
        std::snprintf(text, sizeof text, "%llu%s", static_cast<unsigned long long>(token.value),
                      token.literal == LiteralKind::kUint ? "u" : "");
        return text;
      case kFloatLiteral:
        std::snprintf(text, sizeof text, "%.17e%s", std::bit_cast<double>(token.value),
                      token.literal == LiteralKind::kDouble ? "L" : "");
        return text;
      case kEnd:
      case kUnknown: return "";
      default: return std::string(SpellingOf(token.kind));
    }
  }

  const Names& names_;
  std::vector<Item> items_;
  std::set<std::string> reached_;
};

}  // namespace

std::string PlainText(const Tokens& tokens, const std::string& entry) {
  return Writer(tokens, entry).Run();
}

}  // namespace clipc::draw::reference_compiler
