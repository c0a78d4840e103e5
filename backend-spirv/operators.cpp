// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Operators and conversions.
#include <vector>

#include "backend-spirv/writer.h"

namespace clipc::spirv {

using namespace ir;

namespace {

// The instructions of an operator for floats, signed and unsigned integers, and bools; OpNop where
// there is none.
struct Instructions {
  spv::Op of_float, of_int, of_uint, of_bool;
};

Instructions InstructionsOf(BinaryOp op) {
  using enum spv::Op;
  switch (op) {
    case BinaryOp::kMul: return {OpFMul, OpIMul, OpIMul, OpNop};
    case BinaryOp::kDiv: return {OpFDiv, OpSDiv, OpUDiv, OpNop};
    case BinaryOp::kMod: return {OpNop, OpNop, OpUMod, OpNop};
    case BinaryOp::kAdd: return {OpFAdd, OpIAdd, OpIAdd, OpNop};
    case BinaryOp::kSub: return {OpFSub, OpISub, OpISub, OpNop};
    case BinaryOp::kShiftLeft: return {OpNop, OpShiftLeftLogical, OpShiftLeftLogical, OpNop};
    case BinaryOp::kShiftRight: return {OpNop, OpShiftRightArithmetic, OpShiftRightLogical, OpNop};
    case BinaryOp::kLess: return {OpFOrdLessThan, OpSLessThan, OpULessThan, OpNop};
    case BinaryOp::kGreater: return {OpFOrdGreaterThan, OpSGreaterThan, OpUGreaterThan, OpNop};
    case BinaryOp::kLessEqual:
      return {OpFOrdLessThanEqual, OpSLessThanEqual, OpULessThanEqual, OpNop};
    case BinaryOp::kGreaterEqual:
      return {OpFOrdGreaterThanEqual, OpSGreaterThanEqual, OpUGreaterThanEqual, OpNop};
    case BinaryOp::kEqual: return {OpFOrdEqual, OpIEqual, OpIEqual, OpLogicalEqual};
    case BinaryOp::kNotEqual:
      return {OpFUnordNotEqual, OpINotEqual, OpINotEqual, OpLogicalNotEqual};
    case BinaryOp::kBitAnd: return {OpNop, OpBitwiseAnd, OpBitwiseAnd, OpLogicalAnd};
    case BinaryOp::kBitXor: return {OpNop, OpBitwiseXor, OpBitwiseXor, OpLogicalNotEqual};
    case BinaryOp::kBitOr: return {OpNop, OpBitwiseOr, OpBitwiseOr, OpLogicalOr};
    default: return {OpNop, OpNop, OpNop, OpNop};
  }
}

spv::Op InstructionOf(BinaryOp op, Scalar scalar) {
  const Instructions all = InstructionsOf(op);
  if (IsFloat(scalar)) return all.of_float;
  if (scalar == Scalar::kBool) return all.of_bool;
  return IsUnsigned(scalar) ? all.of_uint : all.of_int;
}

}  // namespace

// Makes a value of the shape out of what make(row, number) gives for each of its rows.
template <typename Make>
Ref Writer::ByRows(const Shape& shape, Make&& make) {
  std::vector<Ref> rows;
  for (std::uint32_t i = 0; i < shape.rows; ++i) rows.push_back(make(shape.Row(), i));
  return Compose(types_.Of(shape), rows);
}

Ref Writer::Splat(const Shape& shape, Ref scalar) {
  if (shape.IsScalar()) return scalar;
  if (shape.IsVector()) return Compose(types_.Of(shape), std::vector<Ref>(shape.size, scalar));
  const Ref row = Splat(shape.Row(), scalar);
  return Compose(types_.Of(shape), std::vector<Ref>(shape.rows, row));
}

Ref Writer::Operate(UnaryOp op, ExprId operand) {
  if (ChangesOperand(op)) return Increment(op, operand);
  const Ref value = Value(operand);
  const Shape shape = ShapeAt(operand);
  const spv::Op instruction = op == UnaryOp::kNot          ? spv::Op::OpLogicalNot
                              : op == UnaryOp::kComplement ? spv::Op::OpNot
                              : shape.IsFloating()         ? spv::Op::OpFNegate
                                                           : spv::Op::OpSNegate;
  if (!shape.HasRows()) return Emit(instruction, types_.Of(shape), {value});
  return ByRows(shape, [&](const Shape& row, std::uint32_t i) {
    return Emit(instruction, types_.Of(row), {Part(types_.Of(row), value, i)});
  });
}

Ref Writer::Increment(UnaryOp op, ExprId operand) {
  const Place place = PlaceOf(operand);
  const Shape shape = ShapeAt(operand);
  const Ref old = Load(place);
  const Ref one = types_.Splat(shape, Types::OneOf(shape.scalar));
  const BinaryOp by = IsIncrement(op) ? BinaryOp::kAdd : BinaryOp::kSub;
  const Ref changed = Combine(by, shape, old, one);
  Store(place, changed);
  return IsPostfix(op) ? old : changed;
}

Ref Writer::Operate(BinaryOp op, ExprId left, ExprId right) {
  if (op == BinaryOp::kShortCircuitAnd || op == BinaryOp::kShortCircuitOr)
    return ShortCircuit(op == BinaryOp::kShortCircuitAnd, left, right);
  const Ref a = Value(left), b = Value(right);
  return Combine(op, ShapeAt(left), a, b);
}

Ref Writer::Combine(BinaryOp op, const Shape& shape, Ref left, Ref right) {
  const spv::Op instruction = InstructionOf(op, shape.scalar);
  if (instruction == spv::Op::OpNop) return Lack("an operator of other types");
  const Shape result = GivesBool(op) ? shape.With(Scalar::kBool) : shape;
  if (!shape.HasRows()) return Compute(instruction, types_.Of(result), {left, right});
  return ByRows(result, [&](const Shape& row, std::uint32_t i) {
    const Ref type = types_.Of(shape.Row());
    return Compute(instruction, types_.Of(row), {Part(type, left, i), Part(type, right, i)});
  });
}

Ref Writer::ShortCircuit(bool is_and, ExprId left, ExprId right) {
  const Ref boolean = types_.Of(Scalar::kBool);
  const Ref first = Value(left);
  if (IsTrivial(right)) {
    const Ref second = Value(right);
    return Emit(is_and ? spv::Op::OpLogicalAnd : spv::Op::OpLogicalOr, boolean, {first, second});
  }
  const Ref before = block_, asked = module_.NewRef(), merge = module_.NewRef();
  Do(spv::Op::OpSelectionMerge, {merge, 0});
  Branch(first, is_and ? asked : merge, is_and ? merge : asked);
  Label(asked);
  const Ref second = Value(right), after = block_;
  Branch(merge);
  Label(merge);
  return Emit(spv::Op::OpPhi, boolean, {first, before, second, after});
}

Ref Writer::Converted(Ref value, const Shape& from, Scalar to_kind) {
  const Scalar to = BaseOf(to_kind);
  if (from.scalar == to) return value;
  if (from.HasRows()) {
    return ByRows(from.With(to), [&](const Shape&, std::uint32_t i) {
      return Converted(Part(types_.Of(from.Row()), value, i), from.Row(), to);
    });
  }
  const Shape shape = from.With(to);
  const Ref type = types_.Of(shape);
  if (to == Scalar::kBool) {
    const spv::Op differs = from.IsFloating() ? spv::Op::OpFUnordNotEqual : spv::Op::OpINotEqual;
    return Emit(differs, type, {value, types_.Splat(from, 0)});
  }
  if (from.scalar == Scalar::kBool) {
    const Ref one = types_.Splat(shape, Types::OneOf(to)), zero = types_.Splat(shape, 0);
    return Emit(spv::Op::OpSelect, type, {value, one, zero});
  }
  if (from.IsFloating()) {
    if (IsFloat(to)) return Emit(spv::Op::OpFConvert, type, {value});
    return Emit(IsUnsigned(to) ? spv::Op::OpConvertFToU : spv::Op::OpConvertFToS, type, {value});
  }
  const bool is_unsigned = IsUnsigned(from.scalar);
  if (IsFloat(to))
    return Emit(is_unsigned ? spv::Op::OpConvertUToF : spv::Op::OpConvertSToF, type, {value});
  if (IsWide(from.scalar) == IsWide(to)) return Emit(spv::Op::OpBitcast, type, {value});
  // The width changes first, with the sign of what it was.
  const Scalar wide = IsWide(to) ? (is_unsigned ? Scalar::kUint64 : Scalar::kInt64)
                                 : (is_unsigned ? Scalar::kUint : Scalar::kInt);
  const Shape middle = from.With(wide);
  const Ref widened =
      Emit(is_unsigned ? spv::Op::OpUConvert : spv::Op::OpSConvert, types_.Of(middle), {value});
  return wide == to ? widened : Emit(spv::Op::OpBitcast, type, {widened});
}

}  // namespace clipc::spirv
