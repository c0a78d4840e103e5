// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "backend-glsl/target.h"
#include "base/kept_blocks.h"
#include "ir/program.h"
#include "legalize/shape.h"

namespace clipc::glsl {

using legalize::Shape;
using legalize::ShapeOf;

// Tells which expressions are constant expressions as the writer writes them: what GLSL asks of the
// value of a `const` variable, and GLSL ES of the value of a global one. glslang, which decides
// what is valid, accepts fewer expressions for constants than section 4.3.3 does.
//
// The answers for variables are kept, so the program must not change while this lives. Asking for
// variables in the order of their declarations keeps the recursion flat.
class Constants {
 public:
  // Requires Form::kLegalized.
  Constants(const ir::Program& program, const Target& target, const legalize::Needs& needs)
      : program_(program), target_(target), needs_(needs), values_(program.vars.size()) {}

  bool Has(ir::ExprId expr);
  // Whether the variable is written with `const`, and so is a constant expression.
  bool Has(ir::VarId var);
  // Whether the value that a variable begins with is a constant expression; without one, its zero.
  bool HasValueOf(ir::VarId var);

 private:
  enum class Answer : std::uint8_t { kUnknown, kNo, kYes };

  // Whether the operand is constant where an operator takes one scalar for a vector or matrix.
  bool HasOperand(ir::ExprId operand);
  // Whether a value of the shape with `scalar` in every component is constant.
  bool HasSplat(const Shape& shape, ir::ExprId scalar);
  bool HasZero(ir::TypeId type) const;
  bool HasAll(List<ir::ExprId> exprs);
  bool HasBinary(const ir::Binary& node);
  bool HasTruncated(ir::TypeId type, ir::ExprId matrix);
  bool HasCall(const ir::Expr& expr, const ir::IntrinsicCall& node);

  const ir::Type& TypeOf(ir::ExprId expr) const {
    return program_.types[program_.exprs[expr].type];
  }
  Shape ShapeAt(ir::ExprId expr) const { return ShapeOf(TypeOf(expr), needs_); }

  const ir::Program& program_;
  const Target& target_;
  const legalize::Needs& needs_;
  KeptVector<Answer> values_;  // by VarId
};

}  // namespace clipc::glsl
