// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "frontend/parse/ast.h"

namespace clipc {

// Returns the tree as indented text, for `--dump=ast` and tests: one line for each declaration and
// statement, expressions with every operator in parentheses. Equal trees have equal texts.
std::string PrintAst(const ast::File& file);

}  // namespace clipc
