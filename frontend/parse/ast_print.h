// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "frontend/parse/ast.h"

namespace clipc {

// The tree as indented text, for `--dump=ast` and tests: a line per declaration and statement;
// expressions on one line with every operator in parentheses. The same tree always prints the same
// text.
std::string PrintAst(const ast::File& file);

}  // namespace clipc
