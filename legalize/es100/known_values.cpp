// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/es100/known_values.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "ir/access.h"
#include "ir/builder.h"
#include "ir/evaluate.h"

namespace clipc::legalize {

using namespace ir;

namespace {

bool IsAnd(BinaryOp op) { return op == BinaryOp::kLogicalAnd || op == BinaryOp::kShortCircuitAnd; }

bool IsWhole(const Type& type) { return type.IsNumeric() && !IsFloat(type.scalar); }

}  // namespace

bool KnownValues::MayKnow(VarId var) const {
  const Var& of = program_.vars[var];
  const Type& type = program_.types[of.type];
  if (of.storage != Storage::kLocal && of.storage != Storage::kIn) return false;
  if (type.kind != TypeKind::kScalar && type.kind != TypeKind::kVector) return false;
  return (IsWhole(type) && !IsWide(type.scalar)) || refused_.IsSource(var);
}

bool KnownValues::IsTable(VarId var) const {
  const Type& type = program_.types[program_.vars[var].type];
  return type.kind == TypeKind::kArray && program_.vars[var].storage == Storage::kLocal &&
         IsWhole(program_.types[type.element]);
}

void KnownValues::Fold(ExprId root, std::vector<StmtId>& before) {
  opaque_.clear();
  FindOpaque(root, false);
  for (const VarId var : opaque_) {
    Store(var, before);
    Forget(var);
  }
  FoldExpr(root);
}

void KnownValues::FoldUnknown(ExprId root) {
  opaque_.clear();
  FindOpaque(root, true);
  FoldExpr(root);
}

// Finds the variables that the expression changes in another way than by assigning to the whole of
// them, or in an operand that may not be evaluated.
void KnownValues::FindOpaque(ExprId expr, bool is_conditional) {
  const auto* assign = As<ir::Assign>(program_, expr);
  const bool is_call = !assign && !As<Unary>(program_, expr);
  ForEachWrite(program_, expr, [&](ExprId target) {
    const VarId root = RootOf(program_, target);
    if (!root || (!MayKnow(root) && !IsTable(root))) return;
    const auto writes_too = [&](ExprId part) {
      bool writes = false;
      ForEachWrite(program_, part, [&](ExprId of) { writes |= RootOf(program_, of) == root; });
      return writes;
    };
    const bool is_twice = assign && AnyExpr(program_, assign->value, writes_too);
    if (is_conditional || is_call || is_twice || IsTable(root) || !As<VarRef>(program_, target))
      opaque_.push_back(root);
  });
  const auto* choice = As<Conditional>(program_, expr);
  const auto* binary = As<Binary>(program_, expr);
  std::size_t number = 0;
  ForEachOperand(program_, expr, [&](ExprId operand) {
    const bool is_skipped = number > 0 && (choice || (binary && IsShortCircuit(binary->op)));
    FindOpaque(operand, is_conditional || is_skipped);
    ++number;
  });
}

void KnownValues::Assign(VarId var, ExprId value) {
  const auto bits = MayKnow(var) ? ConstantBits(program_, value) : std::nullopt;
  if (bits)
    now[var] = {*bits, false};
  else
    Forget(var);
}

StmtId KnownValues::StoreOf(VarId var, const Known& known) {
  Builder b(program_, program_.vars[var].span);
  return b.Eval(b.AssignTo(b.Ref(var), b.ValueOf(program_.vars[var].type, known.bits)));
}

void KnownValues::Store(VarId var, std::vector<StmtId>& stmts) {
  const auto found = now.find(var);
  if (found == now.end() || found->second.is_stored) return;
  stmts.push_back(StoreOf(var, found->second));
  found->second.is_stored = true;
}

// The variable that the whole target is, if its value may be followed; otherwise none.
VarId KnownValues::Target(ExprId target) const {
  const auto* ref = As<VarRef>(program_, target);
  const bool is_followed = ref && MayKnow(ref->var) && !std::ranges::count(opaque_, ref->var);
  return is_followed ? ref->var : VarId{};
}

bool KnownValues::Become(ExprId expr, ExprId other) {
  program_.exprs[expr].node = program_.exprs[other].node;
  return true;
}

bool KnownValues::BecomeValue(ExprId expr, std::span<const std::uint64_t> bits) {
  Builder b(program_, program_.exprs[expr].span);
  return Become(expr, b.ValueOf(program_.exprs[expr].type, bits));
}

// Returns whether a known value is in the expression now.
bool KnownValues::FoldExpr(ExprId expr) {
  if (const auto* ref = As<VarRef>(program_, expr)) {
    const auto found = now.find(ref->var);
    return found != now.end() && !IsTable(ref->var) && BecomeValue(expr, found->second.bits);
  }
  if (const auto* index = As<Index>(program_, expr); index && As<VarRef>(program_, index->base))
    return FoldElement(expr, *index);
  if (const auto* assign = As<ir::Assign>(program_, expr); assign && Target(assign->target))
    return FoldAssign(expr, *assign);
  if (const auto* unary = As<Unary>(program_, expr);
      unary && ChangesOperand(unary->op) && Target(unary->operand))
    return FoldStep(expr, *unary);
  if (const auto* choice = As<Conditional>(program_, expr)) return FoldChoice(expr, *choice);
  if (const auto* binary = As<Binary>(program_, expr); binary && IsLogical(binary->op))
    return FoldBoth(expr, *binary);
  const bool is_folded = FoldOperands(expr);
  if (const auto* comma = As<Comma>(program_, expr); comma && IsPure(program_, comma->first))
    return Become(expr, comma->second) && is_folded;
  if (As<Call>(program_, expr)) on_call(expr);
  if (!is_folded || !IsWhole(TypeOf(program_, expr))) return is_folded;
  if (const auto bits = ConstantBits(program_, expr)) BecomeValue(expr, *bits);
  return true;
}

bool KnownValues::FoldOperands(ExprId expr) {
  bool is_folded = false;
  ForEachOperand(program_, expr, [&](ExprId operand) { is_folded |= FoldExpr(operand); });
  if (const auto* index = As<Index>(program_, expr); is_folded && index) KeepInside(*index);
  return is_folded;
}

// An index that is a number only now may be one that no element has, which GLSL refuses. HLSL
// leaves the value undefined; that of the last element is given.
void KnownValues::KeepInside(Index node) {
  const Type& type = TypeOf(program_, node.base);
  const std::uint32_t count = type.kind == TypeKind::kArray    ? type.count
                              : type.kind == TypeKind::kMatrix ? type.rows
                              : type.IsNumeric()               ? type.columns
                                                               : 0;
  const auto bits = ConstantBits(program_, node.index);
  if (!bits || count == 0 || bits->front() < count) return;
  const std::uint64_t last[] = {count - 1};
  BecomeValue(node.index, last);
}

bool KnownValues::FoldElement(ExprId expr, Index node) {
  const VarId table = As<VarRef>(program_, node.base)->var;
  bool is_folded = FoldExpr(node.base);
  is_folded |= FoldExpr(node.index);
  if (is_folded) KeepInside(node);
  const auto found = now.find(table);
  const auto index = ConstantBits(program_, node.index);
  if (found != now.end() && IsTable(table) && index) {
    const std::size_t count = TypeOf(program_, expr).Components();
    const std::span<const std::uint64_t> bits = found->second.bits;
    if (index->front() < bits.size() / count)
      return BecomeValue(expr, bits.subspan(index->front() * count, count));
  }
  if (!is_folded || !IsWhole(TypeOf(program_, expr))) return is_folded;
  if (const auto bits = ConstantBits(program_, expr)) BecomeValue(expr, *bits);
  return true;
}

bool KnownValues::FoldAssign(ExprId expr, ir::Assign node) {
  const VarId var = Target(node.target);
  bool is_folded = FoldExpr(node.value);
  const auto old = now.find(var);
  if (node.op && old != now.end()) {
    Builder b(program_, program_.exprs[expr].span);
    const ExprId before = b.ValueOf(program_.vars[var].type, old->second.bits);
    node = {std::nullopt, node.target, b.BinaryOf(*node.op, before, node.value)};
    program_.exprs[expr].node = node;
    is_folded = true;
  }
  if (node.op)
    Forget(var);
  else
    Assign(var, node.value);
  const auto known = now.find(var);
  return known == now.end() ? is_folded : BecomeValue(expr, known->second.bits);
}

bool KnownValues::FoldStep(ExprId expr, Unary node) {
  const VarId var = Target(node.operand);
  const auto found = now.find(var);
  if (found == now.end()) return false;
  const TypeId type = program_.vars[var].type;
  Builder b(program_, program_.exprs[expr].span);
  const std::vector<std::uint64_t> old = found->second.bits;
  const ExprId one = b.SplatTo(type, b.LiteralOf(program_.types[type].scalar, 1));
  const BinaryOp op = IsIncrement(node.op) ? BinaryOp::kAdd : BinaryOp::kSub;
  Assign(var, b.BinaryOf(op, b.ValueOf(type, old), one));
  const bool is_old = node.op == UnaryOp::kPostIncrement || node.op == UnaryOp::kPostDecrement;
  return BecomeValue(expr, is_old ? old : now.at(var).bits);
}

bool KnownValues::FoldChoice(ExprId expr, Conditional node) {
  const bool is_folded = FoldExpr(node.condition);
  if (const auto bits = ConstantBits(program_, node.condition)) {
    const ExprId chosen = bits->front() != 0 ? node.when_true : node.when_false;
    FoldExpr(chosen);
    return Become(expr, chosen);
  }
  const bool is_either = FoldExpr(node.when_true);
  return FoldExpr(node.when_false) || is_either || is_folded;
}

// A logical operator of scalars, one side of which is known, is the other side or known itself.
bool KnownValues::FoldBoth(ExprId expr, Binary node) {
  bool is_folded = FoldExpr(node.left);
  const auto left = ConstantBits(program_, node.left);
  const bool is_scalar = TypeOf(program_, expr).kind == TypeKind::kScalar;
  const bool decides = left && is_scalar && (left->front() != 0) != IsAnd(node.op);
  if (decides && IsShortCircuit(node.op)) return Become(expr, node.left);
  is_folded |= FoldExpr(node.right);
  if (decides && IsPure(program_, node.right)) return Become(expr, node.left);
  if (left && is_scalar && !decides) return Become(expr, node.right);
  const auto right = ConstantBits(program_, node.right);
  if (!right || !is_scalar) return is_folded;
  if ((right->front() != 0) == IsAnd(node.op)) return Become(expr, node.left);
  return IsPure(program_, node.left) ? Become(expr, node.right) : is_folded;
}

}  // namespace clipc::legalize
