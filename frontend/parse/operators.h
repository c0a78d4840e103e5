// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string_view>

#include "frontend/parse/ast_expr.h"

namespace clipc::ast {

// How a binary operator is written, and how tightly it binds; all associate to the left.
struct BinaryOperator {
  std::string_view text;
  int precedence;
};
// By BinaryOp.
constexpr BinaryOperator kBinaryOperators[] = {
    {"*", 10}, {"/", 10}, {"%", 10}, {"+", 9},  {"-", 9},  {"<<", 8}, {">>", 8},
    {"<", 7},  {">", 7},  {"<=", 7}, {">=", 7}, {"==", 6}, {"!=", 6}, {"&", 5},
    {"^", 4},  {"|", 3},  {"&&", 2}, {"||", 1}, {",", 0},
};
constexpr const BinaryOperator& OperatorOf(BinaryOp op) {
  return kBinaryOperators[static_cast<std::size_t>(op)];
}
static_assert(OperatorOf(BinaryOp::kComma).text == ",");

}  // namespace clipc::ast
