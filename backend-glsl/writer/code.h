// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/constants.h"
#include "backend-glsl/writer/context.h"

namespace clipc::glsl {

// The state that the subjects of expressions and statements share.
struct Code : WriterContext {
  using WriterContext::WriterContext;

  Constants constants{program, target, needs};
  std::string* out = nullptr;  // the text that expressions and statements are appended to
  std::size_t indent = 0;
  bool in_helper = false;  // in a helper function without globals, whose locals keep their names
  CommentOf comment_of = {};
  std::string comment;  // the last one

  template <typename... Parts>
  void Put(const Parts&... parts) {
    Append(*out, parts...);
  }
  // Appends the text in front of what was appended since `begin`, the size of `out` before it.
  void PutBefore(std::size_t begin, std::string_view text) { out->insert(begin, text); }
  // Puts what was appended since `begin` in parentheses.
  void EncloseFrom(std::size_t begin) {
    PutBefore(begin, "(");
    Put(")");
  }
  // Begins a line of a statement.
  void Indent() { out->append(4 * indent, ' '); }
  template <typename... Parts>
  void Line(const Parts&... parts) {
    Indent();
    Put(parts..., "\n");
  }
  // What write() appends, in a text of its own.
  template <typename Write>
  std::string Apart(Write&& write) {
    std::string text;
    std::string* const whole = std::exchange(out, &text);
    write();
    out = whole;
    return text;
  }
  // A name for a parameter or a variable that is declared here.
  void NameLocal(ir::VarId var, std::string_view fallback) {
    const std::string& wanted = program.vars[var].name;
    names.vars[var.index] = in_helper ? wanted : namer.Local(wanted, fallback);
  }
};

}  // namespace clipc::glsl
