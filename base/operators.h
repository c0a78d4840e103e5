// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

// The operators of HLSL's expressions, which the syntax tree and the program share.
namespace clipc {

enum class UnaryOp : std::uint8_t {
  kNegate,
  kNot,
  kComplement,
  kPreIncrement,
  kPreDecrement,
  kPostIncrement,
  kPostDecrement,
};
enum class BinaryOp : std::uint8_t {
  kMul,
  kDiv,
  kMod,
  kAdd,
  kSub,
  kShiftLeft,
  kShiftRight,
  kLess,
  kGreater,
  kLessEqual,
  kGreaterEqual,
  kEqual,
  kNotEqual,
  kBitAnd,
  kBitXor,
  kBitOr,
  kLogicalAnd,
  kLogicalOr,
  // && and || that evaluate the right side only when the left one does not decide. The syntax tree
  // does not have them: which of the two is meant follows from the profile.
  kShortCircuitAnd,
  kShortCircuitOr,
};

enum class OperatorKind : std::uint8_t {
  kArithmetic,
  kShift,
  kComparison,
  kBitwise,
  kLogical,
  kShortCircuit,
};
struct BinaryOperator {
  std::string_view spelling;
  int precedence;  // a larger one binds tighter; all associate to the left
  OperatorKind kind;
};
// The operators, by BinaryOp.
inline constexpr auto kBinaryOperators = [] {
  using enum OperatorKind;
  return std::to_array<BinaryOperator>({
      {"*", 10, kArithmetic},   {"/", 10, kArithmetic},   {"%", 10, kArithmetic},
      {"+", 9, kArithmetic},    {"-", 9, kArithmetic},    {"<<", 8, kShift},
      {">>", 8, kShift},        {"<", 7, kComparison},    {">", 7, kComparison},
      {"<=", 7, kComparison},   {">=", 7, kComparison},   {"==", 6, kComparison},
      {"!=", 6, kComparison},   {"&", 5, kBitwise},       {"^", 4, kBitwise},
      {"|", 3, kBitwise},       {"&&", 2, kLogical},      {"||", 1, kLogical},
      {"&&", 2, kShortCircuit}, {"||", 1, kShortCircuit},
  });
}();
constexpr const BinaryOperator& TraitsOf(BinaryOp op) {
  return kBinaryOperators[static_cast<std::size_t>(op)];
}
constexpr std::string_view SpellingOf(BinaryOp op) { return TraitsOf(op).spelling; }
constexpr bool IsShift(BinaryOp op) { return TraitsOf(op).kind == OperatorKind::kShift; }
constexpr bool IsBitwise(BinaryOp op) { return TraitsOf(op).kind == OperatorKind::kBitwise; }
constexpr bool IsComparison(BinaryOp op) { return TraitsOf(op).kind == OperatorKind::kComparison; }
constexpr bool IsShortCircuit(BinaryOp op) {
  return TraitsOf(op).kind == OperatorKind::kShortCircuit;
}
// Whether the operator is && or ||, short-circuit or not.
constexpr bool IsLogical(BinaryOp op) {
  return TraitsOf(op).kind == OperatorKind::kLogical || IsShortCircuit(op);
}
constexpr bool GivesBool(BinaryOp op) { return IsComparison(op) || IsLogical(op); }

constexpr bool IsIncrement(UnaryOp op) {
  return op == UnaryOp::kPreIncrement || op == UnaryOp::kPostIncrement;
}
constexpr bool IsPostfix(UnaryOp op) {
  return op == UnaryOp::kPostIncrement || op == UnaryOp::kPostDecrement;
}
// Whether the operator is ++ or --, which need an operand that can be assigned to.
constexpr bool ChangesOperand(UnaryOp op) {
  return IsIncrement(op) || IsPostfix(op) || op == UnaryOp::kPreDecrement;
}
constexpr std::string_view SpellingOf(UnaryOp op) {
  switch (op) {
    case UnaryOp::kNegate: return "-";
    case UnaryOp::kNot: return "!";
    case UnaryOp::kComplement: return "~";
    default: return IsIncrement(op) ? "++" : "--";
  }
}

}  // namespace clipc
