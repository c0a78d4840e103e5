// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace clipc::glsl {

// Returns `wanted` as a GLSL identifier: `$` is left out, other foreign characters become `_`, `__`
// becomes `_`, a reserved prefix (`gl_`, `GL_`, `webgl_`) or a leading digit gets `_` or `x_` in
// front, and a keyword or built-in function gets a `_` at the end. An empty name becomes
// `fallback`.
std::string LegalName(std::string_view wanted, std::string_view fallback = "unnamed");
// Returns the LegalName of a struct field, which may be called like a function, but not like the
// method of arrays, `length`.
std::string LegalFieldName(std::string_view wanted);
// Returns what Namer::Global is asked for in place of `wanted` as the name of a struct: GLSL reads
// it as a type from then on, also in `layout(location = 0)`.
std::string LegalTypeName(std::string_view wanted);

// Hands out names: the wanted one where it is legal and free, else with `_2`, `_3` and so on after
// it. A name depends only on the calls before it.
class Namer {
 public:
  // Returns a name that nothing else has, not even in a function or as a function of an extension.
  std::string Global(std::string_view wanted, std::string_view fallback = "unnamed");
  // Returns a name that nothing visible in the innermost open scope has. Sibling scopes may use it
  // too.
  std::string Local(std::string_view wanted, std::string_view fallback = "value");
  void OpenScope() { scopes_.emplace_back(); }
  void CloseScope();

 private:
  struct Use {
    bool is_global = false;
    bool is_visible_local = false;
    bool is_local = false;  // visible or not
    int last_suffix = 1;    // the last suffix given to a global of this stem
    int next_suffix = 2;    // the smallest suffix that a local of this stem may get
  };
  // A name that a local was given.
  struct Given {
    Use* use;
    Use* stem = nullptr;  // the use of the name without its suffix; null if it has none
    int suffix = 0;
  };
  // The memory of the names of most shaders, which so ask for none.
  std::array<std::byte, 8192> first_memory_;
  std::pmr::monotonic_buffer_resource memory_{first_memory_.data(), first_memory_.size()};
  std::pmr::unordered_map<std::string, Use> uses_{64, &memory_};  // by name
  std::pmr::vector<std::pmr::vector<Given>> scopes_{&memory_};    // the locals of each open scope
};

}  // namespace clipc::glsl
