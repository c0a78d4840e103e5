// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "backend-glsl/operators.h"
#include "backend-glsl/shape.h"
#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

// Operators and calls on operands that are written.
namespace clipc::glsl {

// An operand: its text, or the text of the scalar that each of its components is.
struct Operand {
  Text text;
  Shape shape;
  bool is_scalar = false;            // `text` is the scalar
  std::optional<Constant> constant;  // the number that every component is, where it is known
  bool repeatable = false;           // a scalar, short and without effects: may be written twice
};

Operand OperandOf(Code& code, ir::ExprId id);
std::vector<Operand> OperandsOf(Code& code, List<ir::ExprId> list);

// The operand in its whole shape.
Text Full(Code& code, Operand operand);
// A value of the shape whose components all are `scalar`; `is_zero`: the scalar is known to be 0.
Text SplatText(Code& code, const Text& scalar, const Shape& shape, bool repeatable,
               bool is_zero = false);

Text UnaryOn(Code& code, ir::UnaryOp op, const Operand& operand);
Text BinaryOn(Code& code, ir::BinaryOp op, Operand left, Operand right);
Text ConvertOn(Code& code, ir::Scalar kind, const Operand& operand);

// The call function(operands). Bit i of `scalars`: argument i may be a scalar beside vectors, if
// all such arguments are scalars.
Text CallOn(Code& code, std::string_view function, std::span<const Operand> operands,
            unsigned scalars = 0);
// A call of the snippet `name` (snippets.h) for the first operand's shape.
Text SnippetCall(Code& code, std::string_view name, std::span<const Operand> operands);

}  // namespace clipc::glsl
