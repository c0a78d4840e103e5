// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/names.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "backend-glsl/reserved_words.h"
#include "base/invariant.h"

namespace clipc::glsl {
namespace {

// What a character is in a name: a letter or a digit, an underscore, which may not stand beside
// another one, or neither.
constexpr unsigned kLetterOrDigit = 0, kUnderscore = 1, kNeither = 2;
constexpr auto kCharacters = [] {
  std::array<std::uint8_t, 256> kinds{};
  kinds.fill(kNeither);
  kinds['_'] = kUnderscore;
  for (const char c :
       std::string_view("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789")) {
    kinds[static_cast<unsigned char>(c)] = kLetterOrDigit;
  }
  return kinds;
}();
unsigned KindOf(char c) { return kCharacters[static_cast<unsigned char>(c)]; }
bool IsLetterOrDigit(char c) { return KindOf(c) == kLetterOrDigit; }

constexpr std::string_view kOfWebGl = "webgl_";

// Whether the name is legal as it is, as most names are; false means that Spelling must look at it.
bool IsPlain(std::string_view name) {
  if (name.empty() || !IsLetterOrDigit(name[0]) || name[0] <= '9') return false;
  if (name.size() > 2 && name[2] == '_' && (name[0] == 'g' || name[0] == 'G')) return false;
  unsigned before = kLetterOrDigit;
  for (const char c : name) {
    const unsigned kind = KindOf(c);
    if (kind & (before | kNeither)) return false;
    before = kind;
  }
  return name[0] != kOfWebGl[0] || !name.starts_with(kOfWebGl);
}

// Returns the name in letters, digits and single underscores, not a digit first, outside the
// reserved prefixes (GLSL's gl_, and webgl_ and _webgl_ of WebGL).
std::string Spelling(std::string_view wanted, std::string_view fallback) {
  if (IsPlain(wanted)) return std::string(wanted);
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
  if (std::string_view(name).substr(name.starts_with('_')).starts_with(kOfWebGl))
    name.insert(0, name[0] == '_' ? "x" : "x_");
  return name;
}

std::string WithSuffix(std::string_view name, std::string_view suffix) {
  if (name.ends_with('_')) name.remove_suffix(1);
  return std::string(name) + "_" + std::string(suffix);
}

}  // namespace

std::string LegalName(std::string_view wanted, std::string_view fallback) {
  std::string name = Spelling(wanted, fallback);
  if (IsKeyword(name) || IsBuiltinFunction(name)) name = WithSuffix(name, "");
  return name;
}

std::string LegalFieldName(std::string_view wanted) {
  std::string name = Spelling(wanted, "field");
  if (IsKeyword(name) || name == "length") name = WithSuffix(name, "");
  return name;
}

std::string LegalTypeName(std::string_view wanted) {
  return IsLayoutWord(wanted) ? WithSuffix(wanted, "") : std::string(wanted);
}

std::string Namer::Global(std::string_view wanted, std::string_view fallback) {
  std::string name = LegalName(wanted, fallback);
  if (IsExtensionFunction(name)) name += '_';
  Use* use = &uses_[name];
  if (use->is_global || use->is_local) {
    const std::string stem = name;
    int& suffix = use->last_suffix;
    do {
      name = WithSuffix(stem, std::to_string(++suffix));
      use = &uses_[name];
    } while (use->is_global || use->is_local);
  }
  use->is_global = true;
  return name;
}

std::string Namer::Local(std::string_view wanted, std::string_view fallback) {
  CLIPC_CHECK(!scopes_.empty());
  std::string name = LegalName(wanted, fallback);
  Given given{&uses_[name]};
  if (given.use->is_global || given.use->is_visible_local) {
    const std::string stem = name;
    given.stem = given.use;
    given.suffix = given.stem->next_suffix - 1;
    do {
      name = WithSuffix(stem, std::to_string(++given.suffix));
      given.use = &uses_[name];
    } while (given.use->is_global || given.use->is_visible_local);
    given.stem->next_suffix = given.suffix + 1;
  }
  given.use->is_visible_local = given.use->is_local = true;
  scopes_.back().push_back(given);
  return name;
}

void Namer::CloseScope() {
  CLIPC_CHECK(!scopes_.empty());
  for (const Given& given : scopes_.back()) {
    given.use->is_visible_local = false;
    if (given.stem) given.stem->next_suffix = std::min(given.stem->next_suffix, given.suffix);
  }
  scopes_.pop_back();
}

}  // namespace clipc::glsl
