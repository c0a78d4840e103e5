// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/text.h"

#include <algorithm>

namespace clipc::glsl {

void AppendAll(std::string& text, std::initializer_list<std::string_view> parts) {
  std::size_t size = text.size();
  for (const std::string_view part : parts) size += part.size();
  if (size > text.capacity()) text.reserve(std::max(size, 2 * text.capacity()));
  for (const std::string_view part : parts) {
    // Most parts are a bracket, a space or a comma, for which a call of append is long.
    if (part.size() <= 3)
      for (const char c : part) text.push_back(c);
    else
      text.append(part);
  }
}

}  // namespace clipc::glsl
