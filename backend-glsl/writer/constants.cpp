// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/constants.h"

#include <algorithm>
#include <cmath>

#include "backend-glsl/intrinsics.h"
#include "backend-glsl/operators.h"
#include "backend-glsl/writer/types.h"
#include "base/overloaded.h"
#include "ir/access.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"
#include "ir/walk.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// Infinities and NaNs of floats are calls of uintBitsToFloat, which glslang does not compute.
bool IsComputed(std::uint64_t bits, Scalar kind) {
  return BaseOf(kind) != Scalar::kFloat || std::isfinite(FloatOf(bits));
}

// Whether glslang computes calls of the function with constant arguments.
bool IsComputed(Intrinsic op) {
  switch (op) {
    case Intrinsic::kCosh:
    case Intrinsic::kSinh:
    case Intrinsic::kTanh:
    case Intrinsic::kDeterminant:
    case Intrinsic::kTranspose: return false;
    default: break;
  }
  const IntrinsicInfo& info = InfoOf(op);
  const bool asks_others = info.category == IntrinsicCategory::kWave ||
                           info.category == IntrinsicCategory::kQuad ||
                           info.category == IntrinsicCategory::kNeighbours;
  return !asks_others && info.category != IntrinsicCategory::kBits &&
         info.gate == TargetGate::kNone && !WritesArguments(op);
}

}  // namespace

bool Constants::Has(VarId var) {
  return program_.vars[var].storage == Storage::kConstant && HasValueOf(var);
}

bool Constants::HasValueOf(VarId id) {
  if (values_[id.index] == Answer::kUnknown) {
    const Var& var = program_.vars[id];
    const bool is_constant = var.init ? Has(var.init) : HasZero(var.type);
    values_[id.index] = is_constant ? Answer::kYes : Answer::kNo;
  }
  return values_[id.index] == Answer::kYes;
}

bool Constants::Has(ExprId id) {
  const Expr& expr = program_.exprs[id];
  return Visit(
      Overloaded{
          [&](const Literal& node) { return IsComputed(node.bits, TypeOf(id).scalar); },
          [&](const Zero&) { return HasZero(expr.type); },
          [&](const VarRef& node) { return Has(node.var); },
          [&](const OneOf<FieldRef, Swizzle, MatrixSwizzle> auto& node) { return Has(node.base); },
          [&](const Index& node) {
            return Has(node.base) && (legalize::IsOnlyElement(program_, node) || Has(node.index));
          },
          [&](const Unary& node) { return !ChangesOperand(node.op) && Has(node.operand); },
          [&](const Binary& node) { return HasBinary(node); },
          [&](const Conditional& node) {
            return Has(node.condition) && Has(node.when_true) && Has(node.when_false);
          },
          [&](const Convert& node) {
            const auto* literal = As<Literal>(program_, node.operand);
            const Scalar kind = program_.types[expr.type].scalar;
            return literal
                       ? IsComputed(ConvertBits(literal->bits, TypeOf(node.operand).scalar, kind),
                                    kind)
                       : Has(node.operand);
          },
          [&](const Splat& node) { return HasSplat(ShapeAt(id), node.operand); },
          [&](const Construct& node) { return HasAll(node.arguments); },
          [&](const MatrixTruncate& node) { return HasTruncated(expr.type, node.operand); },
          [&](const IntrinsicCall& node) { return HasCall(expr, node); },
          // glslang does not compute a mix() by bools.
          [](const OneOf<Assign, Select, Call, ObjectCall, Comma> auto&) { return false; },
      },
      expr.node);
}

bool Constants::HasOperand(ExprId operand) {
  const auto* splat = As<Splat>(program_, operand);
  return Has(splat ? splat->operand : operand);
}

// A matrix of a scalar that may not be written twice is the result of a helper function.
bool Constants::HasSplat(const Shape& shape, ExprId scalar) {
  return Has(scalar) && (!shape.HasRows() || IsRepeatable(program_, scalar));
}

// The zero of a long array is the result of a helper function.
bool Constants::HasZero(TypeId id) const {
  const Type& type = program_.types[id];
  if (type.kind == TypeKind::kArray) return type.count < kLongArray && HasZero(type.element);
  return type.kind != TypeKind::kStruct ||
         std::ranges::all_of(program_.types.StructOf(id).fields,
                             [&](const Field& field) { return HasZero(field.type); });
}

bool Constants::HasAll(List<ExprId> exprs) {
  return std::ranges::all_of(program_.expr_lists[exprs], [&](ExprId expr) { return Has(expr); });
}

bool Constants::HasBinary(const Binary& node) {
  const bool is_matrix = ShapeAt(node.left).kind == Shape::kMatrix;
  const bool left_is_scalar = IsOneScalar(program_, node.left);
  const bool right_is_scalar = IsOneScalar(program_, node.right);
  // glslang does not compute matrixCompMult.
  if (is_matrix && node.op == BinaryOp::kMul && !left_is_scalar && !right_is_scalar) return false;
  const bool left_is_whole = left_is_scalar && right_is_scalar;
  return (left_is_whole ? Has(node.left) : HasOperand(node.left)) && HasOperand(node.right);
}

// A column of a matrix that is not the whole matrix is a part of its transpose, which glslang does
// not compute.
bool Constants::HasTruncated(TypeId id, ExprId matrix) {
  const Type& type = program_.types[id];
  const Shape from = ShapeAt(matrix), to = ShapeOf(type, needs_);
  const bool is_part = from != to && to.kind != Shape::kMatrix;
  const bool is_transposed = is_part && from.HasRows() && type.rows != 1;
  return !is_transposed && Has(matrix);
}

bool Constants::HasCall(const Expr& expr, const IntrinsicCall& node) {
  if (!HasAll(node.arguments)) return false;
  const auto arguments = program_.expr_lists[node.arguments];
  const Shape shape = ShapeAt(arguments[0]);
  switch (node.op) {
    case Intrinsic::kMul: {
      // A scalar times a scalar for a whole matrix: the left one is written as a matrix.
      const bool is_splat = shape.IsScalar() && IsOneScalar(program_, arguments[1]);
      return !is_splat || HasSplat(ShapeOf(program_.types[expr.type], needs_), arguments[0]);
    }
    case Intrinsic::kAll:
    case Intrinsic::kAny:
    case Intrinsic::kDot:
    case Intrinsic::kNonUniform:
    case Intrinsic::kSmoothstep: return true;
    default: return IsComputed(node.op) && BuiltinOf(node.op, shape, target_);
  }
}

}  // namespace clipc::glsl
