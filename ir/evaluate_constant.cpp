// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

#include "ir/access.h"
#include "ir/evaluate_machine.h"

// Constant expressions. The expression itself is walked once. A constant variable is evaluated once
// however often it is named, and the work inside variables is bounded: constant arrays that refer
// to constant arrays are a graph that a walk of trees could take exponentially long for. Structs
// and arrays are not evaluated: a member is looked up where it was written.
namespace clipc::ir {
namespace {

constexpr std::uint64_t kMaxSteps = 1u << 14;  // inside variables
constexpr int kMaxDepth = 600;                 // of recursion

// Whether a node of this kind may be constant, whatever its operands are.
bool MayBeConstant(const Program& program, ExprId expr) {
  return Visit(Overloaded{
                   [](const OneOf<Assign, Call, ObjectCall, Comma> auto&) { return false; },
                   [](const Unary& node) { return !ChangesOperand(node.op); },
                   [](const IntrinsicCall& node) {
                     const bool writes = node.arguments.size > 1 && WritesArgument(node.op, 1);
                     return !writes && node.op != CommonIntrinsic::kAsDouble &&
                            node.op != CommonIntrinsic::kCheckAccessFullyMapped &&
                            CategoryOf(node.op) != IntrinsicCategory::kMemory &&
                            CategoryOf(node.op) != IntrinsicCategory::kAtomic &&
                            CategoryOf(node.op) != IntrinsicCategory::kVertices;
                   },
                   [](const auto&) { return true; },
               },
               program.exprs[expr].node);
}

}  // namespace

std::optional<std::vector<Word>> Machine::Constant(ExprId expr) {
  if (WordsOf(expr) > kMaxWords) return std::nullopt;
  only_constants_ = true;
  EvalConstantWhole(expr);
  if (!is_constant_) return std::nullopt;
  return std::move(stack_);
}

// Evaluates a constant of any type.
void Machine::EvalConstantWhole(ExprId expr) {
  if (TypeOf(expr).IsNumeric()) return Eval(expr);
  const ExprId source = SourceOf(expr);
  if (As<Zero>(program_, source)) return PushZeros(WordsOf(expr));
  const auto* construct = As<Construct>(program_, source);
  if (!construct) return PushNoConstant();
  for (const ExprId argument : program_.expr_lists[construct->arguments]) {
    if (is_constant_) EvalConstantWhole(argument);
  }
}

// Evaluates a constant scalar, vector or matrix.
void Machine::EvalConstant(ExprId expr) {
  is_constant_ =
      is_constant_ && !IsTooMuch() && TypeOf(expr).IsNumeric() && MayBeConstant(program_, expr);
  if (!is_constant_) return PushNoConstant();
  ++depth_;
  EvalNode(expr);
  --depth_;
}

// Notes that the expression is not constant, and pushes as many words as an operator may read of an
// operand.
void Machine::PushNoConstant() {
  is_constant_ = false;
  PushZeros(16);
}

bool Machine::IsTooMuch() {
  if (variables_ > 0) ++steps_;
  return steps_ > kMaxSteps || depth_ > kMaxDepth;
}

void Machine::EvalInVariable(ExprId expr) {
  ++variables_;
  Eval(expr);
  --variables_;
}

void Machine::EvalConstantVar(VarId id) {
  const Var& var = program_.vars[id];
  if (var.storage != Storage::kConstant || !var.init) return PushNoConstant();
  if (const auto known = known_.find(id.index); known != known_.end()) {
    stack_.insert(stack_.end(), known->second.begin(), known->second.end());
    return;
  }
  const auto base = static_cast<std::ptrdiff_t>(stack_.size());
  EvalInVariable(var.init);
  known_.emplace(id.index, std::vector<Word>(stack_.begin() + base, stack_.end()));
}

void Machine::EvalConstantMember(ExprId expr) {
  const ExprId member = MemberOf(expr);
  if (!member) return PushNoConstant();
  if (As<Zero>(program_, member)) return PushZeros(WordsOf(expr));
  EvalInVariable(member);
}

// The Construct or Zero that a constant struct or array is, found through variables, fields and
// indices; none for a value that is not constant.
ExprId Machine::SourceOf(ExprId expr) {
  if (IsTooMuch()) return {};
  if (As<Construct>(program_, expr) || As<Zero>(program_, expr)) return expr;
  ++depth_;
  ExprId source;
  if (const auto* ref = As<VarRef>(program_, expr)) {
    const Var& var = program_.vars[ref->var];
    if (var.storage == Storage::kConstant && var.init) source = SourceOf(var.init);
  } else if (WholeOf(program_, expr)) {
    source = MemberOf(expr);
  }
  --depth_;
  return source;
}

// The expression that gives a field or element its value; the Zero itself when all of the struct or
// array is zero.
ExprId Machine::MemberOf(ExprId expr) {
  const ExprId base = WholeOf(program_, expr);
  const auto* index = As<Index>(program_, expr);
  const auto* field = As<FieldRef>(program_, expr);
  std::optional<std::uint32_t> number;
  if (field) number = field->field;
  if (index && TypeOf(base).kind == TypeKind::kArray)
    number = IndexInto(TypeOf(base), index->index);
  const ExprId source = number && is_constant_ ? SourceOf(base) : ExprId{};
  const auto* construct = As<Construct>(program_, source);
  if (!construct) return source;
  const auto arguments = program_.expr_lists[construct->arguments];
  if (*number >= arguments.size()) return {};
  const ExprId member = arguments[*number];
  return TypeOf(member).IsNumeric() ? member : SourceOf(member);
}

std::optional<std::vector<std::uint64_t>> ConstantBits(const Program& program, ExprId expr) {
  static const EvalInputs kNoInputs;
  static const EvalOptions kInFloat;
  return Machine(program, kNoInputs, kInFloat).Constant(expr);
}

}  // namespace clipc::ir
