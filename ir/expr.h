// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>

#include "base/arena.h"
#include "base/operators.h"
#include "base/span.h"
#include "ir/ids.h"
#include "ir/intrinsic.h"
#include "ir/object_op.h"
#include "ir/type.h"

// Expressions. program.h says what holds of all of them.
namespace clipc::ir {

// A scalar constant. `bits` are 0 or 1 for a bool, the value for an integer, those of a float for
// the float kinds, and those of a double for double. Vectors and matrices of constants are
// Constructs of Literals.
struct Literal {
  std::uint64_t bits = 0;
  bool is_mask = false;  // an integer that people read in hexadecimal, of a helper function
};
// A zero of any type, structs and arrays included: (T)0.
struct Zero {};
struct VarRef {
  VarId var;
};
struct FieldRef {
  ExprId base;  // of struct type
  std::uint32_t field = 0;
};
// An element: array[i], a component: vector[i], or a row: matrix[i]. The index is an int or uint
// scalar. Reads of StructuredBuffer and Buffer are ObjectCalls.
struct Index {
  ExprId base, index;
};
// Components of a vector: base.xyz. One component gives a scalar. In an assignment target no
// component repeats.
struct Swizzle {
  ExprId base;
  std::array<std::uint8_t, 4> components{};
  std::uint8_t count = 0;
};
// Components of a matrix, as a value only: m._m00_m11. `base` is a path of variables, fields and
// constant or pure indices. Assignments to such components are assignments to Index nodes.
struct MatrixSwizzle {
  ExprId base;
  std::array<std::uint8_t, 4> rows{}, columns{};
  std::uint8_t count = 0;
};
// An operator with one operand. kNot takes a bool shape. The operators that change their operand
// take an lvalue of an int, uint or float shape.
using clipc::UnaryOp;
struct Unary {
  UnaryOp op = UnaryOp::kNegate;
  ExprId operand;
};
// A component-wise operator with two operands. They have the same type; those of a shift need only
// the same shape. Comparisons and logical operators give bool of that shape. kMod of floats is
// fmod: the result has the sign of the dividend. Shift counts are taken modulo 32. The logical
// operators evaluate both sides, as HLSL before 2021 does; the short-circuit forms are for scalars
// (HLSL 2021).
using clipc::BinaryOp;
struct Binary {
  BinaryOp op = BinaryOp::kMul;
  ExprId left, right;
};
// target = value, or target op= value; both have the same type. The value of the expression is the
// target's new value. A target is a path of VarRef, FieldRef, Index and at most one last Swizzle.
struct Assign {
  std::optional<BinaryOp> op;  // an arithmetic, bit or shift operator
  ExprId target, value;
};
// A choice by a bool scalar. Only the chosen side is evaluated: where HLSL evaluates both and that
// matters, both are computed before.
struct Conditional {
  ExprId condition, when_true, when_false;
};
// A choice of each component by a bool vector or matrix. All three operands are evaluated.
struct Select {
  ExprId condition, when_true, when_false;
};
// A conversion to the same shape with another component kind. float to int truncates; to bool is
// != 0; from bool is 0 or 1; signed and unsigned keep the bits. Between half, float and
// minimum-precision floats it is the identity.
struct Convert {
  ExprId operand;
};
// A vector or matrix with one scalar in every component.
struct Splat {
  ExprId operand;
};
// A vector, from scalars and vectors of the same kind whose components add up; a matrix, from
// scalars in row order, from its rows or from its only column; a struct or an array, from one
// expression for each field or element, of exactly its type.
struct Construct {
  List<ExprId> arguments;
};
// The upper left part of a matrix.
struct MatrixTruncate {
  ExprId operand;
};
// A call of a function. Arguments have exactly the parameters' types. Those of out and inout
// parameters are assignment targets: copied in before the call (inout) and out after it, from left
// to right.
struct Call {
  FunctionId function;
  List<ExprId> arguments;
};
struct IntrinsicCall {
  Intrinsic op{};
  List<ExprId> arguments;
};
// A read or write through a texture or buffer object. `arguments` are the operands that ir/ops.def
// lists, in its order.
struct ObjectCall {
  ObjectOp op{};
  List<ExprId> arguments;
  // Whether there are operands of tiled resources, which follow the arguments in the pool: the node
  // is small for the many calls without them. The clamp is the least level of detail of a sample.
  // The texel is a variable of the value that the call has otherwise, but of four components if it
  // is not a comparison: it is written, and the call's value is a uint, the status.
  bool has_clamp = false, has_texel = false;
  // The arguments and those operands, as one list.
  List<ExprId> Operands() const {
    return {arguments.begin, arguments.size + std::uint32_t{has_clamp} + std::uint32_t{has_texel}};
  }
};
// An expression that evaluates `first`, then `second`, whose value it has.
struct Comma {
  ExprId first, second;
};

struct Expr {
  TypeId type;
  Span span;
  std::variant<Literal, Zero, VarRef, FieldRef, Index, Swizzle, MatrixSwizzle, Unary, Binary,
               Assign, Conditional, Select, Convert, Splat, Construct, MatrixTruncate, Call,
               IntrinsicCall, ObjectCall, Comma>
      node;
};

}  // namespace clipc::ir
