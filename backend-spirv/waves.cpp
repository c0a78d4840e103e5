// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Functions of waves and quads, by the operations of groups that are not uniform.
#include <algorithm>
#include <iterator>

#include "backend-spirv/writer.h"
#include "ir/intrinsic_list.h"

namespace clipc::spirv {

using namespace ir;

namespace {

using Cap = spv::Capability;
using Way = spv::GroupOperation;

// An operation that combines the lanes' values, for floats, signed and unsigned integers.
struct CombiningRow {
  ir::Intrinsic op;
  spv::Op of_float, of_int, of_uint;
  spv::GroupOperation way;
};
constexpr CombiningRow kCombining[] = {
    {ir::Intrinsic::kWaveActiveBitAnd, spv::Op::OpNop, spv::Op::OpGroupNonUniformBitwiseAnd,
     spv::Op::OpGroupNonUniformBitwiseAnd, Way::Reduce},
    {ir::Intrinsic::kWaveActiveBitOr, spv::Op::OpNop, spv::Op::OpGroupNonUniformBitwiseOr,
     spv::Op::OpGroupNonUniformBitwiseOr, Way::Reduce},
    {ir::Intrinsic::kWaveActiveBitXor, spv::Op::OpNop, spv::Op::OpGroupNonUniformBitwiseXor,
     spv::Op::OpGroupNonUniformBitwiseXor, Way::Reduce},
    {ir::Intrinsic::kWaveActiveMax, spv::Op::OpGroupNonUniformFMax, spv::Op::OpGroupNonUniformSMax,
     spv::Op::OpGroupNonUniformUMax, Way::Reduce},
    {ir::Intrinsic::kWaveActiveMin, spv::Op::OpGroupNonUniformFMin, spv::Op::OpGroupNonUniformSMin,
     spv::Op::OpGroupNonUniformUMin, Way::Reduce},
    {ir::Intrinsic::kWaveActiveProduct, spv::Op::OpGroupNonUniformFMul,
     spv::Op::OpGroupNonUniformIMul, spv::Op::OpGroupNonUniformIMul, Way::Reduce},
    {ir::Intrinsic::kWaveActiveSum, spv::Op::OpGroupNonUniformFAdd, spv::Op::OpGroupNonUniformIAdd,
     spv::Op::OpGroupNonUniformIAdd, Way::Reduce},
    {ir::Intrinsic::kWavePrefixProduct, spv::Op::OpGroupNonUniformFMul,
     spv::Op::OpGroupNonUniformIMul, spv::Op::OpGroupNonUniformIMul, Way::ExclusiveScan},
    {ir::Intrinsic::kWavePrefixSum, spv::Op::OpGroupNonUniformFAdd, spv::Op::OpGroupNonUniformIAdd,
     spv::Op::OpGroupNonUniformIAdd, Way::ExclusiveScan},
    {ir::Intrinsic::kWaveMultiPrefixBitAnd, spv::Op::OpNop, spv::Op::OpGroupNonUniformBitwiseAnd,
     spv::Op::OpGroupNonUniformBitwiseAnd, Way::PartitionedExclusiveScanNV},
    {ir::Intrinsic::kWaveMultiPrefixBitOr, spv::Op::OpNop, spv::Op::OpGroupNonUniformBitwiseOr,
     spv::Op::OpGroupNonUniformBitwiseOr, Way::PartitionedExclusiveScanNV},
    {ir::Intrinsic::kWaveMultiPrefixBitXor, spv::Op::OpNop, spv::Op::OpGroupNonUniformBitwiseXor,
     spv::Op::OpGroupNonUniformBitwiseXor, Way::PartitionedExclusiveScanNV},
    {ir::Intrinsic::kWaveMultiPrefixCountBits, spv::Op::OpNop, spv::Op::OpGroupNonUniformIAdd,
     spv::Op::OpGroupNonUniformIAdd, Way::PartitionedExclusiveScanNV},
    {ir::Intrinsic::kWaveMultiPrefixProduct, spv::Op::OpGroupNonUniformFMul,
     spv::Op::OpGroupNonUniformIMul, spv::Op::OpGroupNonUniformIMul,
     Way::PartitionedExclusiveScanNV},
    {ir::Intrinsic::kWaveMultiPrefixSum, spv::Op::OpGroupNonUniformFAdd,
     spv::Op::OpGroupNonUniformIAdd, spv::Op::OpGroupNonUniformIAdd,
     Way::PartitionedExclusiveScanNV},
};

// Another operation of one value.
struct PlainRow {
  ir::Intrinsic op;
  spv::Op instruction;
  spv::Capability capability;
};
constexpr PlainRow kPlain[] = {
    {ir::Intrinsic::kWaveActiveAllEqual, spv::Op::OpGroupNonUniformAllEqual,
     Cap::GroupNonUniformVote},
    {ir::Intrinsic::kWaveActiveAllTrue, spv::Op::OpGroupNonUniformAll, Cap::GroupNonUniformVote},
    {ir::Intrinsic::kWaveActiveAnyTrue, spv::Op::OpGroupNonUniformAny, Cap::GroupNonUniformVote},
    {ir::Intrinsic::kWaveActiveBallot, spv::Op::OpGroupNonUniformBallot,
     Cap::GroupNonUniformBallot},
    {ir::Intrinsic::kWaveReadLaneFirst, spv::Op::OpGroupNonUniformBroadcastFirst,
     Cap::GroupNonUniformBallot},
};

}  // namespace

// The instruction with the scope of a wave. Values are the operand, and what follows it.
Ref Writer::OfWave(spv::Op op, spv::Capability capability, Ref type,
                   std::initializer_list<std::uint32_t> operands) {
  module_.Require(Cap::GroupNonUniform);
  module_.Require(capability);
  Words all{types_.Uint(NumberOf(spv::Scope::Subgroup))};
  all.insert(all.end(), operands);
  return Emit(op, type, all);
}

Ref Writer::Wave(TypeId id, const IntrinsicCall& node) {
  using enum ir::Intrinsic;
  const auto arguments = (*this)[node.arguments];
  const Ref type = types_.Of(id);
  Ref value = Value(arguments[0]);
  Shape shape = ShapeAt(arguments[0]);
  const auto* combining = std::ranges::find(kCombining, node.op, &CombiningRow::op);
  if (combining != std::end(kCombining)) {
    if (node.op == kWaveMultiPrefixCountBits) {
      value = Converted(value, shape, Scalar::kUint);
      shape = shape.With(Scalar::kUint);
    }
    const spv::Op op = shape.IsFloating()         ? combining->of_float
                       : IsUnsigned(shape.scalar) ? combining->of_uint
                                                  : combining->of_int;
    const std::uint32_t way = NumberOf(combining->way);
    if (arguments.size() == 1)
      return OfWave(op, Cap::GroupNonUniformArithmetic, type, {way, value});
    module_.Require("SPV_NV_shader_subgroup_partitioned");
    const Ref parts = Value(arguments[1]);
    return OfWave(op, Cap::GroupNonUniformPartitionedNV, type, {way, value, parts});
  }
  const auto* plain = std::ranges::find(kPlain, node.op, &PlainRow::op);
  if (plain != std::end(kPlain))
    return OfWave(plain->instruction, plain->capability, type, {value});
  const auto count = [&](spv::GroupOperation way) {
    const Ref four = types_.Of(ShapeOf(Scalar::kUint, 1, 4));
    const Ref ballot =
        OfWave(spv::Op::OpGroupNonUniformBallot, Cap::GroupNonUniformBallot, four, {value});
    return OfWave(spv::Op::OpGroupNonUniformBallotBitCount, Cap::GroupNonUniformBallot, type,
                  {NumberOf(way), ballot});
  };
  // Directions: 0 is horizontal, 1 vertical, 2 diagonal.
  const auto swap = [&](std::uint32_t direction) {
    return OfWave(spv::Op::OpGroupNonUniformQuadSwap, Cap::GroupNonUniformQuad, type,
                  {value, types_.Uint(direction)});
  };
  switch (node.op) {
    case kWaveActiveCountBits: return count(Way::Reduce);
    case kWavePrefixCountBits: return count(Way::ExclusiveScan);
    case kWaveMatch:
      module_.Require("SPV_NV_shader_subgroup_partitioned");
      module_.Require(Cap::GroupNonUniformPartitionedNV);
      module_.Require(Cap::GroupNonUniform);
      return Emit(spv::Op::OpGroupNonUniformPartitionNV, type, {value});
    case kWaveReadLaneAt:
      return OfWave(spv::Op::OpGroupNonUniformShuffle, Cap::GroupNonUniformShuffle, type,
                    {value, Value(arguments[1])});
    case kQuadReadAcrossX: return swap(0);
    case kQuadReadAcrossY: return swap(1);
    case kQuadReadAcrossDiagonal: return swap(2);
    case kQuadReadLaneAt: return FromQuad(type, value, arguments[1]);
    default: return Lack("a function of waves");
  }
}

// The value in a lane of the quad. A broadcast takes constants only.
Ref Writer::FromQuad(Ref type, Ref value, ExprId lane) {
  const Ref number = Value(lane);
  if (As<Literal>(lane))
    return OfWave(spv::Op::OpGroupNonUniformQuadBroadcast, Cap::GroupNonUniformQuad, type,
                  {value, number});
  const Ref uint = types_.Of(Scalar::kUint);
  const Ref first =
      Emit(spv::Op::OpBitwiseAnd, uint, {LoadBuiltin(Builtin::kLaneIndex), types_.Uint(~3u)});
  const Ref wanted = Emit(spv::Op::OpIAdd, uint, {first, number});
  return OfWave(spv::Op::OpGroupNonUniformShuffle, Cap::GroupNonUniformShuffle, type,
                {value, wanted});
}

}  // namespace clipc::spirv
