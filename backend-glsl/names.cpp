// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/names.h"

#include "backend-glsl/reserved_words.h"
#include "base/check.h"

namespace clipc::glsl {
namespace {

bool IsLetterOrDigit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

// Letters, digits and single underscores, not a digit first, outside the reserved prefixes.
std::string Spelling(std::string_view wanted, std::string_view fallback) {
  std::string name;
  name.reserve(wanted.size() + 2);
  for (char c : wanted) {
    if (c == '$') continue;  // of $Globals
    if (!IsLetterOrDigit(c)) c = '_';
    if (c == '_' && name.ends_with('_')) continue;
    name += c;
  }
  if (name.empty() || name == "_") name = fallback;
  if (name[0] >= '0' && name[0] <= '9') name.insert(0, "_");
  if (name.starts_with("gl_") || name.starts_with("GL_")) name.insert(0, "_");
  return name;
}

std::string WithSuffix(std::string_view name, std::string_view suffix) {
  if (name.ends_with('_')) name.remove_suffix(1);
  return std::string(name) + "_" + std::string(suffix);
}

}  // namespace

std::string LegalName(std::string_view wanted, std::string_view fallback) {
  std::string name = Spelling(wanted, fallback);
  return IsKeyword(name) || IsBuiltinFunction(name) ? WithSuffix(name, "") : name;
}

std::string LegalFieldName(std::string_view wanted) {
  std::string name = Spelling(wanted, "field");
  return IsKeyword(name) ? WithSuffix(name, "") : name;
}

std::string Namer::Global(std::string_view wanted, std::string_view fallback) {
  const std::string stem = LegalName(wanted, fallback);
  std::string name = stem;
  while (globals_.contains(name) || all_locals_.contains(name)) {
    int& suffix = last_suffix_.try_emplace(stem, 1).first->second;
    name = WithSuffix(stem, std::to_string(++suffix));
  }
  globals_.insert(name);
  return name;
}

std::string Namer::Local(std::string_view wanted, std::string_view fallback) {
  CLIPC_CHECK(!scopes_.empty());
  const std::string stem = LegalName(wanted, fallback);
  std::string name = stem;
  for (int suffix = 2; globals_.contains(name) || visible_locals_.contains(name); ++suffix) {
    name = WithSuffix(stem, std::to_string(suffix));
  }
  visible_locals_.insert(name);
  all_locals_.insert(name);
  scopes_.back().push_back(name);
  return name;
}

void Namer::CloseScope() {
  CLIPC_CHECK(!scopes_.empty());
  for (const std::string& name : scopes_.back()) visible_locals_.erase(name);
  scopes_.pop_back();
}

}  // namespace clipc::glsl
