// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <fmt/format.h>

#include "ir/access.h"
#include "ir/verifier.h"

namespace clipc::ir {

void ExprVerifier::Check(const ObjectCall& node) {
  Require(program_.calls_objects, "the program says that it calls objects");
  const ObjectOpInfo& info = InfoOf(node.op);
  const std::uint32_t size = node.arguments.size;
  if (!Require(size >= info.least && (size <= info.most || info.most == ObjectOpInfo::kUnlimited),
               "wrong number of operands"))
    return;
  const std::uint32_t offsets = OperandsOf(node, OperandKind::kOffset).size;
  Require(offsets <= 1 || offsets == 4, "there is one offset, or one for each of four texels");
  ForEachNamedOperand(program_, node, [&](OperandKind kind, ExprId operand) {
    if (!IsOperand(node, kind, operand))
      Require(false, fmt::format("the wrong kind of {}", NameOf(kind)));
  });
  if (node.has_texel)
    Require(Checked().scalar == Scalar::kUint, "a status is a uint");
  else
    Require(IsResult(node), "the type of a call is that of the operation's result");
}

// Whether the operand is one of its kind.
bool ExprVerifier::IsOperand(const ObjectCall& node, OperandKind kind, ExprId operand) const {
  const Type& type = TypeOf(operand);
  const bool is_number = type.kind == TypeKind::kScalar;
  switch (kind) {
    case OperandKind::kObject:
    case OperandKind::kSampler: {
      ExprId path = operand;
      while (const auto* index = As<Index>(program_, path)) path = index->base;
      if (type.kind != TypeKind::kObject || !As<VarRef>(program_, path)) return false;
      const ObjectCategory category = InfoOf(type.object).category;
      if (kind == OperandKind::kSampler) return category == ObjectCategory::kSampler;
      return (InfoOf(node.op).objects >> static_cast<unsigned>(category) & 1) != 0 &&
             (IsWritable(type.object) || !WritesObject(node.op));
    }
    case OperandKind::kCoordinate:
    case OperandKind::kDdx:
    case OperandKind::kDdy: return type.IsScalarOrVector() && IsFloat(type.scalar);
    case OperandKind::kPlace:
    case OperandKind::kOffset: return type.IsScalarOrVector() && IsInteger(type.scalar);
    case OperandKind::kReference:
    case OperandKind::kBias:
    case OperandKind::kClamp: return is_number && IsFloat(type.scalar);
    case OperandKind::kLevel:
      return is_number && (Takes(node.op, OperandKind::kCoordinate) ? IsFloat(type.scalar)
                                                                    : IsInteger(type.scalar));
    case OperandKind::kSample:
    case OperandKind::kStep: return is_number && IsInteger(type.scalar);
    case OperandKind::kComparand:
      return IdOf(operand) == IdOf(OperandOf(program_, node, OperandKind::kValue));
    case OperandKind::kValue:
      return !IsAtomic(node.op) || (is_number && (IsInteger(type.scalar) || Exchanges(node.op)));
    case OperandKind::kTexel: return IsTarget(operand);
  }
  return false;
}

bool ExprVerifier::IsResult(const ObjectCall& node) const {
  const Type& type = Checked();
  const bool is_vector = type.IsScalarOrVector();
  switch (InfoOf(node.op).result) {
    case ObjectResult::kVoid: return type.kind == TypeKind::kVoid;
    case ObjectResult::kElement: {
      const Type& object = TypeOf(OperandOf(program_, node, OperandKind::kObject));
      if (object.element) return IdOf(expr_) == object.element;
      return is_vector && type.scalar == Scalar::kFloat &&
             type.columns == (InfoOf(object.object).compares ? 1 : 4);
    }
    case ObjectResult::kFloat:
      return type.kind == TypeKind::kScalar && type.scalar == Scalar::kFloat;
    case ObjectResult::kFourTexels: return is_vector && type.columns == 4;
    case ObjectResult::kInts: return is_vector && type.scalar == Scalar::kInt;
    case ObjectResult::kUints: return is_vector && type.scalar == Scalar::kUint;
    case ObjectResult::kOldValue:
      return IdOf(expr_) == IdOf(OperandOf(program_, node, OperandKind::kValue));
  }
  return false;
}

}  // namespace clipc::ir
