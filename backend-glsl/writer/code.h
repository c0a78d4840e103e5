// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/context.h"

namespace clipc::glsl {

// What the subjects of expressions and statements share.
struct Code : Context {
  using Context::Context;

  std::set<ir::VarId> mutable_constants;  // written without `const`
  // The names and values of global variables that get their value in `main`, as ES wants it.
  std::vector<std::pair<std::string, std::string>> late_globals;
  std::string* out = nullptr;  // where Line writes
  std::size_t indent = 0;
  bool in_helper = false;  // whose names nothing else can take
  std::string comment;     // the last one from options.comment_of

  template <typename... Parts>
  void Line(const Parts&... parts) {
    out->append(4 * indent, ' ');
    Append(*out, parts..., "\n");
  }
  // A name for a parameter or a variable that is declared here.
  void NameLocal(ir::VarId var, std::string_view fallback) {
    const std::string& wanted = program.vars[var].name;
    var_names[var.index] = in_helper ? wanted : namer.Local(wanted, fallback);
  }
};

}  // namespace clipc::glsl
