// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

#include "ir/evaluate_machine.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

// The functions of waves and, in a group, of quads: four lanes whose numbers begin at a multiple of
// 4. A lane is active at a call if it comes by with the same calls and iterations around it.
namespace clipc::ir {
namespace {

// The lanes that count, beside all that are active.
enum class Among : std::uint8_t { kActive, kBefore, kBeforeInMask };

// A function that adds up the operands of lanes, from the lowest on, or joins them otherwise.
struct Fold {
  Intrinsic op;
  Intrinsic joins_as;  // the function over all active lanes that joins in the same way
  Among among = Among::kActive;
};

using enum Intrinsic;

constexpr Fold kFolds[] = {
    {kWaveActiveSum, kWaveActiveSum},
    {kWaveActiveProduct, kWaveActiveProduct},
    {kWaveActiveMin, kWaveActiveMin},
    {kWaveActiveMax, kWaveActiveMax},
    {kWaveActiveBitAnd, kWaveActiveBitAnd},
    {kWaveActiveBitOr, kWaveActiveBitOr},
    {kWaveActiveBitXor, kWaveActiveBitXor},
    {kWavePrefixSum, kWaveActiveSum, Among::kBefore},
    {kWavePrefixProduct, kWaveActiveProduct, Among::kBefore},
    {kWaveMultiPrefixSum, kWaveActiveSum, Among::kBeforeInMask},
    {kWaveMultiPrefixProduct, kWaveActiveProduct, Among::kBeforeInMask},
    {kWaveMultiPrefixBitAnd, kWaveActiveBitAnd, Among::kBeforeInMask},
    {kWaveMultiPrefixBitOr, kWaveActiveBitOr, Among::kBeforeInMask},
    {kWaveMultiPrefixBitXor, kWaveActiveBitXor, Among::kBeforeInMask},
    {kWaveActiveCountBits, kWaveActiveCountBits},
    {kWavePrefixCountBits, kWaveActiveCountBits, Among::kBefore},
    {kWaveMultiPrefixCountBits, kWaveActiveCountBits, Among::kBeforeInMask},
};

Word Join(Intrinsic op, Scalar rep, Word sum, Word next) {
  switch (op) {
    case kWaveActiveProduct: return BinaryComponent(BinaryOp::kMul, rep, sum, next);
    case kWaveActiveMin: return ComponentFunction(kMin, rep, sum, next, 0);
    case kWaveActiveMax: return ComponentFunction(kMax, rep, sum, next, 0);
    case kWaveActiveBitAnd: return BinaryComponent(BinaryOp::kBitAnd, rep, sum, next);
    case kWaveActiveBitOr: return BinaryComponent(BinaryOp::kBitOr, rep, sum, next);
    case kWaveActiveBitXor: return BinaryComponent(BinaryOp::kBitXor, rep, sum, next);
    default: return BinaryComponent(BinaryOp::kAdd, rep, sum, next);
  }
}

// The value of a fold over no lane at all.
Word Nothing(Intrinsic op, Scalar rep) {
  if (op == kWaveActiveProduct) return ConvertBits(BitsOf(1.0), Scalar::kDouble, rep);
  return op == kWaveActiveBitAnd ? ConvertBits(0xffffffffu, Scalar::kUint, rep) : 0;
}

using LaneBits = std::array<Word, 4>;  // words of 32 bits, as WaveActiveBallot gives them

void Set(LaneBits& bits, std::size_t lane) { bits[lane / 32 % 4] |= Word{1} << lane % 32; }
bool Has(std::span<const Word> bits, std::size_t lane) {
  return (bits[lane / 32 % 4] >> lane % 32 & 1) != 0;
}

// The bits of the lanes for which that holds.
template <typename Holds>
LaneBits BitsWhere(const Lanes::Operands& operands, Holds&& holds) {
  LaneBits bits{};
  for (std::size_t i = 0; i < operands.size(); ++i)
    if (operands[i] && holds(operands[i])) Set(bits, i);
  return bits;
}

// The lane that a function reads, of one that asks for the lane `asked`.
std::size_t LaneRead(Intrinsic op, const Lanes::Operands& operands, std::size_t lane, Word asked) {
  switch (op) {
    case kQuadReadAcrossX: return lane ^ 1;
    case kQuadReadAcrossY: return lane ^ 2;
    case kQuadReadAcrossDiagonal: return lane ^ 3;
    case kQuadReadLaneAt: return (lane & ~std::size_t{3}) + asked % kQuadPixels;
    case kWaveReadLaneFirst:
      return static_cast<std::size_t>(
          std::ranges::find_if(operands, [](const Word* words) { return words != nullptr; }) -
          operands.begin());
    default: return static_cast<std::size_t>(asked);
  }
}

}  // namespace

// Evaluates a function of a wave or a quad in a thread of a group.
void Machine::EvalWave(ExprId expr, const IntrinsicCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  const std::size_t base = stack_.size();
  Eval(arguments[0]);
  const std::size_t end = stack_.size();
  for (std::size_t i = 1; i < arguments.size(); ++i) Eval(arguments[i]);
  const std::vector<Word> second(stack_.begin() + static_cast<std::ptrdiff_t>(end), stack_.end());
  stack_.resize(end);
  const std::vector<Word> own(stack_.begin() + static_cast<std::ptrdiff_t>(base), stack_.end());
  stack_.resize(base);
  const Lanes& lanes = thread_->lanes();
  const Lanes::Operands operands = thread_->lanes().Ask({flow_, expr.index}, own);
  const auto fold = std::ranges::find(kFolds, node.op, &Fold::op);
  if (fold != std::end(kFolds)) {
    Lanes::Operands some = operands;
    for (std::size_t i = 0; i < some.size(); ++i) {
      if (fold->among != Among::kActive && i >= lanes.lane()) some[i] = nullptr;
      if (fold->among == Among::kBeforeInMask && !Has(second, i)) some[i] = nullptr;
    }
    return PushFold(expr, fold->joins_as, some);
  }
  const auto same = [&](const Word* words) { return std::equal(own.begin(), own.end(), words); };
  const auto is_true = [](const Word* words) { return words[0] != 0; };
  const auto is_of_quad = [&](std::size_t lane) { return lane / 4 == lanes.lane() / 4; };
  const auto push_bits = [&](const LaneBits& bits) {
    stack_.insert(stack_.end(), bits.begin(), bits.end());
  };
  bool all = true, any = false;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (!operands[i] || (CategoryOf(node.op) == IntrinsicCategory::kQuad && !is_of_quad(i)))
      continue;
    all = all && is_true(operands[i]);
    any = any || is_true(operands[i]);
  }
  switch (node.op) {
    case kWaveActiveBallot: return push_bits(BitsWhere(operands, is_true));
    case kWaveMatch: return push_bits(BitsWhere(operands, same));
    case kQuadAll:
    case kWaveActiveAllTrue: return stack_.push_back(all);
    case kQuadAny:
    case kWaveActiveAnyTrue: return stack_.push_back(any);
    case kWaveActiveAllEqual: return PushAllEqual(RepOf(arguments[0]), own, operands);
    default: break;
  }
  const std::size_t source =
      LaneRead(node.op, operands, lanes.lane(), second.empty() ? 0 : second[0]);
  // A lane that does not come by has no value.
  if (source >= operands.size() || !operands[source])
    return PushUndefined(program_.exprs[expr].type);
  stack_.insert(stack_.end(), operands[source], operands[source] + own.size());
}

// Pushes what the operands give together; null ones do not count.
void Machine::PushFold(ExprId expr, Intrinsic op, const Lanes::Operands& operands) {
  const Scalar rep = RepOf(expr);
  for (std::uint32_t i = 0; i < WordsOf(expr); ++i) {
    Word sum = Nothing(op, rep);
    bool is_first = true;
    for (const Word* words : operands) {
      if (!words) continue;
      sum = is_first ? words[i] : Join(op, rep, sum, words[i]);
      is_first = false;
    }
    stack_.push_back(sum);
  }
}

// Pushes for each component whether it is equal in all lanes.
void Machine::PushAllEqual(Scalar rep, std::span<const Word> own, const Lanes::Operands& operands) {
  for (std::size_t i = 0; i < own.size(); ++i) {
    stack_.push_back(std::ranges::all_of(operands, [&](const Word* words) {
      return !words || BinaryComponent(BinaryOp::kEqual, rep, own[i], words[i]) != 0;
    }));
  }
}

}  // namespace clipc::ir
