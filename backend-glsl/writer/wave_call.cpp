// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/wave_call.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/operand.h"
#include "base/invariant.h"
#include "ir/intrinsic_list.h"

namespace clipc::glsl {

using namespace ir;

namespace {

struct Row {
  Intrinsic op;
  Feature feature;
  // The text around the arguments: "subgroupAdd(", ")".
  std::string_view before, after = ")";
};

constexpr Row kRows[] = {
    {Intrinsic::kWaveActiveAllEqual, Feature::kSubgroupVotes, "subgroupAllEqual("},
    {Intrinsic::kWaveActiveAllTrue, Feature::kSubgroupVotes, "subgroupAll("},
    {Intrinsic::kWaveActiveAnyTrue, Feature::kSubgroupVotes, "subgroupAny("},
    {Intrinsic::kWaveActiveBallot, Feature::kSubgroupBallots, "subgroupBallot("},
    {Intrinsic::kWaveActiveBitAnd, Feature::kSubgroupArithmetic, "subgroupAnd("},
    {Intrinsic::kWaveActiveBitOr, Feature::kSubgroupArithmetic, "subgroupOr("},
    {Intrinsic::kWaveActiveBitXor, Feature::kSubgroupArithmetic, "subgroupXor("},
    {Intrinsic::kWaveActiveCountBits, Feature::kSubgroupBallots,
     "subgroupBallotBitCount(subgroupBallot(", "))"},
    {Intrinsic::kWaveActiveMax, Feature::kSubgroupArithmetic, "subgroupMax("},
    {Intrinsic::kWaveActiveMin, Feature::kSubgroupArithmetic, "subgroupMin("},
    {Intrinsic::kWaveActiveProduct, Feature::kSubgroupArithmetic, "subgroupMul("},
    {Intrinsic::kWaveActiveSum, Feature::kSubgroupArithmetic, "subgroupAdd("},
    {Intrinsic::kWaveMatch, Feature::kSubgroupPartitions, "subgroupPartitionNV("},
    {Intrinsic::kWaveMultiPrefixBitAnd, Feature::kSubgroupPartitions,
     "subgroupPartitionedExclusiveAndNV("},
    {Intrinsic::kWaveMultiPrefixBitOr, Feature::kSubgroupPartitions,
     "subgroupPartitionedExclusiveOrNV("},
    {Intrinsic::kWaveMultiPrefixBitXor, Feature::kSubgroupPartitions,
     "subgroupPartitionedExclusiveXorNV("},
    {Intrinsic::kWaveMultiPrefixCountBits, Feature::kSubgroupPartitions,
     "subgroupPartitionedExclusiveAddNV("},
    {Intrinsic::kWaveMultiPrefixProduct, Feature::kSubgroupPartitions,
     "subgroupPartitionedExclusiveMulNV("},
    {Intrinsic::kWaveMultiPrefixSum, Feature::kSubgroupPartitions,
     "subgroupPartitionedExclusiveAddNV("},
    {Intrinsic::kWavePrefixCountBits, Feature::kSubgroupBallots,
     "subgroupBallotExclusiveBitCount(subgroupBallot(", "))"},
    {Intrinsic::kWavePrefixProduct, Feature::kSubgroupArithmetic, "subgroupExclusiveMul("},
    {Intrinsic::kWavePrefixSum, Feature::kSubgroupArithmetic, "subgroupExclusiveAdd("},
    {Intrinsic::kWaveReadLaneAt, Feature::kSubgroupShuffles, "subgroupShuffle("},
    {Intrinsic::kWaveReadLaneFirst, Feature::kSubgroupBallots, "subgroupBroadcastFirst("},
    {Intrinsic::kQuadAll, Feature::kSubgroupQuads, ""},  // helper functions that call the others
    {Intrinsic::kQuadAny, Feature::kSubgroupQuads, ""},
    {Intrinsic::kQuadReadAcrossDiagonal, Feature::kSubgroupQuads, "subgroupQuadSwapDiagonal("},
    {Intrinsic::kQuadReadAcrossX, Feature::kSubgroupQuads, "subgroupQuadSwapHorizontal("},
    {Intrinsic::kQuadReadAcrossY, Feature::kSubgroupQuads, "subgroupQuadSwapVertical("},
    {Intrinsic::kQuadReadLaneAt, Feature::kSubgroupQuads, "subgroupQuadBroadcast("},
};

const Row& RowOf(Intrinsic op) {
  const auto* row = std::ranges::find(kRows, op, &Row::op);
  CLIPC_CHECK(row != std::end(kRows));
  return *row;
}

}  // namespace

Feature FeatureOfWave(Intrinsic op) { return RowOf(op).feature; }

Binding WriteWave(Code& code, const IntrinsicCall& node) {
  const auto arguments = code[node.arguments];
  const Row& row = RowOf(node.op);
  code.Require(row.feature);
  const Scalar kind = TypeOf(code.program, arguments[0]).scalar;
  if (IsInteger(kind) && IsWide(kind)) code.Require(Feature::kSubgroupInt64);
  std::string_view before = row.before, second_before = ", ", second_after = "";
  if (node.op == Intrinsic::kQuadReadLaneAt && !code.As<Literal>(arguments[1])) {
    // subgroupQuadBroadcast takes constants only.
    code.Require(Feature::kSubgroups);
    code.Require(Feature::kSubgroupShuffles);
    before = "subgroupShuffle(";
    second_before = ", (gl_SubgroupInvocationID & ~3u) + (";
    second_after = ")";
  }
  code.Put(before);
  if (node.op == Intrinsic::kWaveMultiPrefixCountBits) {
    code.Put("uint(");
    WriteAt(code, arguments[0], Binding::kAssignment);
    code.Put(")");
  } else {
    WriteAt(code, arguments[0], Binding::kAssignment);
  }
  if (arguments.size() > 1) {
    code.Put(second_before);
    WriteAt(code, arguments[1], Binding::kAssignment);
    code.Put(second_after);
  }
  code.Put(row.after);
  return Binding::kPostfix;
}

}  // namespace clipc::glsl
