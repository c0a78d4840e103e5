// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/divisors.h"

#include <algorithm>

#include "base/overloaded.h"
#include "ir/access.h"
#include "ir/evaluate.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"
#include "ir/walk.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// The operators and variables that are looked through.
constexpr int kMaxLevels = 16;

}  // namespace

bool Divisors::MayBeZero(ExprId expr, int depth) {
  const Type& type = TypeOf(program_, expr);
  if (depth == kMaxLevels || !type.IsNumeric() || !IsInteger(type.scalar)) return true;
  if (const auto bits = ConstantBits(program_, expr))
    return std::ranges::find(*bits, 0) != bits->end();
  const auto may_be = [&](ExprId part) { return MayBeZero(part, depth + 1); };
  return Visit(
      Overloaded{
          [&](const VarRef& node) {
            const ExprId value = ValueOf(node.var);
            return !value || may_be(value);
          },
          [&](const OneOf<Swizzle> auto& node) { return may_be(node.base); },
          [&](const OneOf<Convert, Splat> auto& node) { return may_be(node.operand); },
          [&](const Unary& node) { return node.op != UnaryOp::kNegate || may_be(node.operand); },
          [&](const Binary& node) { return MayBeZero(node, depth); },
          [&](const OneOf<Conditional, Select> auto& node) {
            return may_be(node.when_true) || may_be(node.when_false);
          },
          [&](const Construct& node) {
            return std::ranges::any_of(program_.expr_lists[node.arguments], may_be);
          },
          [&](const IntrinsicCall& node) { return MayBeZero(node, depth); },
          [](const auto&) { return true; },
      },
      program_.exprs[expr].node);
}

bool Divisors::MayBeZero(const Binary& node, int depth) {
  if (node.op == BinaryOp::kBitOr)
    return MayBeZero(node.left, depth + 1) && MayBeZero(node.right, depth + 1);
  // The bit of 1 << n is never shifted out, since the count is modulo the number of bits.
  const auto bits =
      node.op == BinaryOp::kShiftLeft ? ConstantBits(program_, node.left) : std::nullopt;
  return !bits || std::ranges::any_of(*bits, [](std::uint64_t word) { return word != 1; });
}

bool Divisors::MayBeZero(const IntrinsicCall& node, int depth) {
  const auto arguments = program_.expr_lists[node.arguments];
  switch (node.op) {
    case Intrinsic::kMax:
      if (IsAboveZero(arguments[0]) || IsAboveZero(arguments[1])) return false;
      [[fallthrough]];
    case Intrinsic::kMin:
      return MayBeZero(arguments[0], depth + 1) || MayBeZero(arguments[1], depth + 1);
    case Intrinsic::kClamp: return !IsAboveZero(arguments[1]) || !IsAboveZero(arguments[2]);
    case Intrinsic::kAbs: return MayBeZero(arguments[0], depth + 1);
    default: return true;
  }
}

bool Divisors::IsAboveZero(ExprId expr) const {
  const auto bits = ConstantBits(program_, expr);
  const Scalar kind = TypeOf(program_, expr).scalar;
  return bits &&
         std::ranges::all_of(*bits, [&](std::uint64_t word) { return NumberOf(word, kind) > 0; });
}

ExprId Divisors::ValueOf(VarId var) {
  const Storage storage = program_.vars[var].storage;
  if (storage != Storage::kLocal && storage != Storage::kStatic) return {};
  if (given_.empty()) FindValues();
  return var.index < given_.size() && given_[var.index].times == 1 ? given_[var.index].value
                                                                   : ExprId{};
}

void Divisors::FindValues() {
  given_.resize(program_.vars.size());
  const auto give = [&](VarId var, ExprId value) {
    ++given_[var.index].times;
    given_[var.index].value = value;
  };
  for (const VarId var : program_.vars.ids()) {
    const Var& row = program_.vars[var];
    // A static variable without a value begins with 0; another value of a constant_id may be 0.
    if (row.storage == Storage::kStatic) give(var, row.constant_id ? ExprId{} : row.init);
  }
  for (const FunctionId function : program_.functions.ids()) {
    ForEachStmt(program_, program_.functions[function].body, [&](StmtId stmt) {
      const auto* declare = As<Declare>(program_, stmt);
      if (declare && declare->init) give(declare->var, declare->init);
    });
  }
  ForEachLiveExpr(program_, [&](ExprId expr) {
    ForEachWrite(program_, expr, [&](ExprId target) {
      if (const VarId root = RootOf(program_, target)) {
        const auto* assign = As<Assign>(program_, expr);
        const bool is_whole = assign && !assign->op && As<VarRef>(program_, target);
        give(root, is_whole ? assign->value : ExprId{});
      }
    });
  });
}

}  // namespace clipc::legalize
