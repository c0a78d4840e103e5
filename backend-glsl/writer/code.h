// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/constants.h"
#include "backend-glsl/writer/context.h"

namespace clipc::glsl {

// The state that the subjects of expressions and statements share.
struct Code : Context {
  using Context::Context;

  Constants constants{program, target};
  std::string* out = nullptr;  // the text that Line appends to
  std::size_t indent = 0;
  bool in_helper = false;  // in a helper function, whose locals keep their names
  std::string comment;     // the last comment from options.comment_of

  template <typename... Parts>
  void Line(const Parts&... parts) {
    out->append(4 * indent, ' ');
    Append(*out, parts..., "\n");
  }
  // A name for a parameter or a variable that is declared here.
  void NameLocal(ir::VarId var, std::string_view fallback) {
    const std::string& wanted = program.vars[var].name;
    names.vars[var.index] = in_helper ? wanted : namer.Local(wanted, fallback);
  }
};

}  // namespace clipc::glsl
