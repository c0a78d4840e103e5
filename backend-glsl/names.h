// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <memory_resource>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace clipc::glsl {

// `wanted` as a GLSL identifier: other characters become `_`, `__` becomes `_`, `gl_` and `GL_` get
// a `_` in front, and keywords and built-in functions get a `_` at the end. `fallback` stands in
// for an empty name.
std::string LegalName(std::string_view wanted, std::string_view fallback = "unnamed");
// LegalName for struct fields, which may be called like a function.
std::string LegalFieldName(std::string_view wanted);

// Hands out names: the wanted one where it is legal and free, else with `_2`, `_3` and so on after
// it. A name depends only on the calls before it.
class Namer {
 public:
  // A name that nothing else has, in no function either.
  std::string Global(std::string_view wanted, std::string_view fallback = "unnamed");
  // A name that nothing visible in the innermost open scope has. Sibling scopes may use it too.
  std::string Local(std::string_view wanted, std::string_view fallback = "value");
  void OpenScope() { scopes_.emplace_back(); }
  void CloseScope();

 private:
  struct Use {
    bool is_global = false;
    bool is_visible_local = false;
    bool is_local = false;  // visible or not
    int last_suffix = 1;    // that was given to a global of this stem
    int next_suffix = 2;    // the smallest one that a local of this stem may get
  };
  // A name that a local was given.
  struct Given {
    Use* use;
    Use* stem = nullptr;  // that of the name without its suffix; null where it has none
    int suffix = 0;
  };
  std::pmr::monotonic_buffer_resource memory_{4096};
  std::pmr::unordered_map<std::string, Use> uses_{64, &memory_};  // by name
  std::vector<std::vector<Given>> scopes_;                        // their locals
};

}  // namespace clipc::glsl
