// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "link/names.h"

namespace clipc::link {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

bool IsWordCharacter(char c) {
  return c == '_' || IsDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string GlslNameOf(std::string_view name) {
  std::string text = !name.empty() && IsDigit(name[0]) ? "_" : "";
  for (const char c : name) {
    const char spelled = IsWordCharacter(c) ? c : '_';
    if (spelled != '_' || !text.ends_with('_')) text += spelled;
  }
  return text;
}

}  // namespace clipc::link
