// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/evaluate_quad.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ir/evaluate_machine.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

namespace clipc::ir {

std::optional<Lanes::Operands> Neighbours::AskAll(LaneKey key, std::span<const Word> own) {
  Operands operands = Ask(key, own);
  if (std::ranges::count(operands, nullptr) > 0) return std::nullopt;
  return operands;
}

void Machine::EvalDerivative(ExprId expr, const IntrinsicCall& node) {
  const std::size_t base = stack_.size();
  Eval(program_.expr_lists[node.arguments][0]);
  const auto operands = neighbours_->AskAll({flow_, expr.index}, std::span(stack_).subspan(base));
  stack_.resize(base);
  if (!operands) return PushUndefined(program_.exprs[expr].type);
  const Scalar rep = RepOf(expr);
  const auto change = [&](std::size_t first, std::size_t second, std::uint32_t i) {
    return BinaryComponent(BinaryOp::kSub, rep, (*operands)[second][i], (*operands)[first][i]);
  };
  const auto size = [&](Word word) {
    return ComponentFunction(Intrinsic::kAbs, rep, word, word, word);
  };
  for (std::uint32_t i = 0; i < WordsOf(expr); ++i) {
    const Word x = change(neighbours_->FirstAlongX(), neighbours_->SecondAlongX(), i);
    const Word y = change(neighbours_->FirstAlongY(), neighbours_->SecondAlongY(), i);
    switch (node.op) {
      case Intrinsic::kDdx:
      case Intrinsic::kDdxCoarse:
      case Intrinsic::kDdxFine: stack_.push_back(x); break;
      case Intrinsic::kFwidth:
        stack_.push_back(BinaryComponent(BinaryOp::kAdd, rep, size(x), size(y)));
        break;
      default: stack_.push_back(y);
    }
  }
}

void Machine::EvalQuad(ExprId expr, const IntrinsicCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  std::size_t source = neighbours_->lane();
  if (node.op == Intrinsic::kQuadReadLaneAt) {
    Eval(arguments[1]);
    source = UintOf(stack_.back()) % kQuadPixels;
    stack_.pop_back();
  }
  const std::size_t base = stack_.size();
  Eval(arguments[0]);
  const auto operands = neighbours_->AskAll({flow_, expr.index}, std::span(stack_).subspan(base));
  stack_.resize(base);
  if (!operands) return PushUndefined(program_.exprs[expr].type);
  const auto is_true = [](const Word* words) { return words[0] != 0; };
  switch (node.op) {
    case Intrinsic::kQuadAll: stack_.push_back(std::ranges::all_of(*operands, is_true)); return;
    case Intrinsic::kQuadAny: stack_.push_back(std::ranges::any_of(*operands, is_true)); return;
    case Intrinsic::kQuadReadAcrossX: source ^= 1; break;
    case Intrinsic::kQuadReadAcrossY: source ^= 2; break;
    case Intrinsic::kQuadReadAcrossDiagonal: source ^= 3; break;
    default: break;
  }
  const Word* words = (*operands)[source];
  stack_.insert(stack_.end(), words, words + WordsOf(expr));
}

std::vector<double> Machine::CoordinatesOf(ExprId call, Scalar rep, std::span<const Word> own) {
  const auto operands = neighbours_->AskAll({flow_, call.index}, own);
  if (!operands) return std::vector<double>(kQuadPixels * own.size(), std::nan(""));
  std::vector<double> all;
  for (const Word* words : *operands) {
    for (std::size_t i = 0; i < own.size(); ++i) all.push_back(NumberOf(words[i], rep));
  }
  return all;
}

std::array<EvalResult, kQuadPixels> RunQuad(const Program& program,
                                            const std::array<EvalInputs, kQuadPixels>& pixels,
                                            const EvalOptions& options) {
  std::array<EvalResult, kQuadPixels> results;
  LaneNotes before, notes(kQuadPixels);
  do {
    before = std::exchange(notes, LaneNotes(kQuadPixels));
    for (std::size_t i = 0; i < kQuadPixels; ++i) {
      Neighbours neighbours(i, before, notes);
      results[i] = Machine(program, pixels[i], options, &neighbours).Run();
    }
  } while (notes != before);
  return results;
}

}  // namespace clipc::ir
