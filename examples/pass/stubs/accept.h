// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <string>

// What both stubs do in the place of a compiler.
namespace stub {

// Returns what is wrong with the text for such a compiler: an include that `can_read` does not
// find, clip planes, which it would drop, or no clip distances. Empty: nothing is.
inline std::string ProblemOf(const std::string& text,
                             const std::function<bool(const std::string& name)>& can_read) {
  const std::string include = "#include \"";
  for (std::size_t at = text.find(include); at != std::string::npos; at = text.find(include, at)) {
    at += include.size();
    const std::string name = text.substr(at, text.find('"', at) - at);
    if (!can_read(name)) return "there is no file " + name;
  }
  if (text.find("[clipplanes") != std::string::npos) return "unknown attribute clipplanes";
  return text.find("SV_ClipDistance") == std::string::npos ? "there are no clip distances" : "";
}

}  // namespace stub
