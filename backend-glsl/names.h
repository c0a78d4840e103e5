// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace clipc::glsl {

// `wanted` as a GLSL identifier: other characters become `_`, `__` becomes `_`, `gl_` and `GL_` get a `_` in front,
// and keywords and built-in functions get a `_` behind. `fallback` stands in for an empty name.
std::string LegalName(std::string_view wanted, std::string_view fallback = "unnamed");
// The same for struct fields, which may be called like a function.
std::string LegalFieldName(std::string_view wanted);

// Hands out names: the wanted one where it is legal and free, else with `_2`, `_3` and so on behind it. A name depends
// only on the calls before it.
class Namer {
 public:
  // A name that nothing else has, in no function either.
  std::string Global(std::string_view wanted, std::string_view fallback = "unnamed");
  // A name that nothing visible in the innermost open scope has. Sibling scopes may use it too.
  std::string Local(std::string_view wanted, std::string_view fallback = "value");
  void OpenScope() { scopes_.emplace_back(); }
  void CloseScope();

 private:
  std::unordered_set<std::string> globals_;
  std::unordered_set<std::string> visible_locals_;
  std::unordered_set<std::string> all_locals_;
  std::unordered_map<std::string, int> last_suffix_;  // of globals
  std::vector<std::vector<std::string>> scopes_;
};

}  // namespace clipc::glsl
