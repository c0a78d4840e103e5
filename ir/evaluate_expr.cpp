// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "ir/access.h"
#include "ir/evaluate_machine.h"
#include "ir/scalar.h"

namespace clipc::ir {

void Machine::EvalNode(ExprId expr) {
  std::visit([&](const auto& node) { EvalNode(expr, node); }, program_.exprs[expr].node);
}

void Machine::EvalNode(ExprId expr, const Literal& node) {
  stack_.push_back(FromBits(node.bits, TypeOf(expr).scalar));
}

void Machine::EvalNode(ExprId, const Conditional& node) {
  Eval(Test(node.condition) ? node.when_true : node.when_false);
}

void Machine::EvalNode(ExprId expr, const Splat& node) {
  Eval(node.operand);
  stack_.resize(stack_.size() + WordsOf(expr) - 1, stack_.back());
}

void Machine::EvalNode(ExprId, const Construct& node) {
  for (ExprId argument : program_.expr_lists[node.arguments]) Eval(argument);
}

void Machine::EvalNode(ExprId, const Comma& node) {
  EvalAndDrop(node.first);
  Eval(node.second);
}

void Machine::EvalAndDrop(ExprId expr) {
  const std::size_t base = stack_.size();
  Eval(expr);
  stack_.resize(base);
}

Word Machine::EvalScalar(ExprId expr) {
  Eval(expr);
  const Word word = stack_.back();
  stack_.pop_back();
  return word;
}

void Machine::EvalInto(ExprId expr, std::uint32_t address) {
  const std::size_t base = stack_.size();
  Eval(expr);
  Store({.address = address}, static_cast<std::uint32_t>(stack_.size() - base),
        stack_.data() + base);
  stack_.resize(base);
}

void Machine::Keep(std::size_t base, std::size_t from, std::uint32_t words) {
  std::copy_n(stack_.begin() + static_cast<std::ptrdiff_t>(from), words,
              stack_.begin() + static_cast<std::ptrdiff_t>(base));
  stack_.resize(base + words);
}

void Machine::Keep(std::size_t base, int count, const std::array<std::size_t, 4>& places) {
  std::array<Word, 4> kept{};
  for (int i = 0; i < count; ++i) kept[i] = stack_[base + places[i]];
  stack_.resize(base);
  stack_.insert(stack_.end(), kept.begin(), kept.begin() + count);
}

// ---- variables and their parts

void Machine::EvalNode(ExprId, const VarRef& node) {
  if (only_constants_) return EvalConstantVar(node.var);
  PushFrom({.address = address_[node.var.index]}, program_.vars[node.var].type);
}

bool Machine::IsPath(ExprId expr) const {
  while (As<FieldRef>(program_, expr) || As<Index>(program_, expr)) expr = WholeOf(program_, expr);
  return As<VarRef>(program_, expr) != nullptr;
}

// Evaluates a field or an element. A part of a variable is read in place, so that an index into a
// large array copies one element.
void Machine::EvalPart(ExprId expr) {
  const std::uint32_t words = WordsOf(expr);
  if (const auto* index = As<Index>(program_, expr);
      index && TypeOf(index->base).kind == TypeKind::kArray && TypeOf(index->base).count == 0) {
    return EvalUnsizedElement(*index);
  }
  if (only_constants_) {
    if (!TypeOf(WholeOf(program_, expr)).IsNumeric()) return EvalConstantMember(expr);
  } else if (IsPath(expr)) {
    return PushFrom(Locate(expr), program_.exprs[expr].type);
  }
  const std::size_t base = stack_.size();
  if (const auto* field = As<FieldRef>(program_, expr)) {
    Eval(field->base);
    return Keep(base, base + FieldWord(TypeOf(field->base).structure, field->field), words);
  }
  const Index& index = std::get<Index>(program_.exprs[expr].node);
  Eval(index.base);
  const auto element = IndexInto(TypeOf(index.base), index.index);
  if (element) return Keep(base, base + std::size_t{*element} * words, words);
  stack_.resize(base);
  PushUndefined(program_.exprs[expr].type);
}

// Pushes an object of an array without a size, whose elements have no place in memory.
void Machine::EvalUnsizedElement(const Index& node) {
  if (only_constants_) return PushNoConstant();
  const Word element = UintOf(EvalScalar(node.index));
  stack_.push_back(Word{RootOf(program_, node.base).index} << 32 | element);
}

std::optional<std::uint32_t> Machine::IndexInto(const Type& base, ExprId index) {
  const Word word = ConvertBits(EvalScalar(index), RepOf(index), Scalar::kInt64);
  const std::uint32_t count = base.kind == TypeKind::kArray    ? base.count
                              : base.kind == TypeKind::kMatrix ? base.rows
                                                               : base.columns;
  if (word < count) return static_cast<std::uint32_t>(word);  // a negative index is a large word
  is_constant_ = false;
  return std::nullopt;
}

Machine::TargetWords Machine::Locate(ExprId expr) {
  if (const auto* ref = As<VarRef>(program_, expr)) return {.address = address_[ref->var.index]};
  if (const auto* field = As<FieldRef>(program_, expr)) {
    TargetWords place = Locate(field->base);
    place.address += FieldWord(TypeOf(field->base).structure, field->field);
    return place;
  }
  if (const auto* index = As<Index>(program_, expr)) {
    TargetWords place = Locate(index->base);
    const auto element = IndexInto(TypeOf(index->base), index->index);
    place.in_bounds = place.in_bounds && element.has_value();
    place.address += element.value_or(0) * WordsOf(expr);
    return place;
  }
  const Swizzle& swizzle = std::get<Swizzle>(program_.exprs[expr].node);
  TargetWords place = Locate(swizzle.base);
  place.count = swizzle.count;
  place.components = swizzle.components;
  return place;
}

void Machine::PushUndefined(TypeId type) {
  if (options_.undefined == 0) return PushZeros(WordsOf(type));
  const std::vector<Scalar> kinds = KindsOf(program_.types, type);
  const bool negated = NextUndefinedIsNegated();
  for (std::size_t i = 0; i < kinds.size(); ++i)
    stack_.push_back(UndefinedOf(kinds[i], i, negated));
}

void Machine::PushFrom(const TargetWords& place, TypeId type) {
  if (!place.in_bounds) return PushUndefined(type);
  const std::uint32_t words = WordsOf(type);
  const bool is_shared = thread_ && place.address < shared_words_;
  for (std::uint32_t i = 0; i < words; ++i) {
    const std::uint32_t word = place.address + (place.count != 0 ? place.components[i] : i);
    stack_.push_back(is_shared ? thread_->Read(word, is_atomic_) : memory_[word]);
  }
}

void Machine::Store(const TargetWords& place, std::uint32_t words, const Word* from) {
  if (!place.in_bounds) {
    wrote_out_of_bounds_ = true;
    return;
  }
  const bool is_shared = thread_ && place.address < shared_words_;
  for (std::uint32_t i = 0; i < words; ++i) {
    const std::uint32_t word = place.address + (place.count != 0 ? place.components[i] : i);
    if (is_shared)
      thread_->Write(word, from[i], is_atomic_);
    else
      memory_[word] = from[i];
  }
}

void Machine::EvalNode(ExprId, const Swizzle& node) {
  const std::size_t base = stack_.size();
  Eval(node.base);
  std::array<std::size_t, 4> places{};
  for (int i = 0; i < node.count; ++i) places[i] = node.components[i];
  Keep(base, node.count, places);
}

void Machine::EvalNode(ExprId, const MatrixSwizzle& node) {
  const std::size_t base = stack_.size();
  Eval(node.base);
  const std::size_t columns = TypeOf(node.base).columns;
  std::array<std::size_t, 4> places{};
  for (int i = 0; i < node.count; ++i) places[i] = node.rows[i] * columns + node.columns[i];
  Keep(base, node.count, places);
}

// ---- operators

void Machine::EvalNode(ExprId, const Unary& node) {
  const Scalar rep = RepOf(node.operand);
  const std::uint32_t words = WordsOf(node.operand);
  const std::size_t base = stack_.size();
  if (!ChangesOperand(node.op)) {
    Eval(node.operand);
    for (std::uint32_t i = 0; i < words; ++i)
      stack_[base + i] = UnaryComponent(node.op, rep, stack_[base + i]);
    return;
  }
  const TargetWords place = Locate(node.operand);
  PushFrom(place, program_.exprs[node.operand].type);
  PushFrom(place, program_.exprs[node.operand].type);
  for (std::uint32_t i = 0; i < words; ++i) {
    stack_[base + words + i] = UnaryComponent(node.op, rep, stack_[base + words + i]);
  }
  Store(place, words, stack_.data() + base + words);
  const bool is_post = node.op == UnaryOp::kPostIncrement || node.op == UnaryOp::kPostDecrement;
  Keep(base, is_post ? base : base + words, words);
}

void Machine::EvalNode(ExprId, const Binary& node) {
  // The sides of a constant are constant, and so may be evaluated.
  if (IsShortCircuit(node.op) && !only_constants_) return EvalShortCircuit(node);
  const Scalar rep = RepOf(node.left);
  const std::uint32_t words = WordsOf(node.left);
  const std::size_t base = stack_.size();
  Eval(node.left);
  Eval(node.right);
  const bool divides = (node.op == BinaryOp::kDiv || node.op == BinaryOp::kMod) && !IsFloat(rep);
  for (std::uint32_t i = 0; i < words; ++i) {
    if (divides && stack_[base + words + i] == 0) is_constant_ = false;
    stack_[base + i] = BinaryComponent(node.op, rep, stack_[base + i], stack_[base + words + i]);
  }
  stack_.resize(base + words);
}

void Machine::EvalShortCircuit(const Binary& node) {
  const bool is_and = node.op == BinaryOp::kShortCircuitAnd;
  const bool left = Test(node.left);
  if (left == is_and) return Eval(node.right);
  stack_.push_back(left ? 1 : 0);
}

void Machine::EvalNode(ExprId, const Assign& node) {
  const Scalar rep = RepOf(node.target);
  const std::uint32_t words = WordsOf(node.target);
  const std::size_t base = stack_.size();
  const TargetWords place = Locate(node.target);
  Eval(node.value);
  if (node.op) {
    PushFrom(place, program_.exprs[node.target].type);
    for (std::uint32_t i = 0; i < words; ++i) {
      stack_[base + i] = BinaryComponent(*node.op, rep, stack_[base + words + i], stack_[base + i]);
    }
    stack_.resize(base + words);
  }
  Store(place, words, stack_.data() + base);
}

void Machine::EvalNode(ExprId, const Select& node) {
  const std::uint32_t words = WordsOf(node.condition);
  const std::size_t base = stack_.size();
  Eval(node.condition);
  Eval(node.when_true);
  Eval(node.when_false);
  for (std::uint32_t i = 0; i < words; ++i) {
    stack_[base + i] = stack_[base + (stack_[base + i] != 0 ? words : 2 * words) + i];
  }
  stack_.resize(base + words);
}

void Machine::EvalNode(ExprId expr, const Convert& node) {
  const std::size_t base = stack_.size();
  Eval(node.operand);
  const Scalar from = RepOf(node.operand);
  const Scalar to = RepOf(expr);
  for (std::size_t i = base; i < stack_.size(); ++i) stack_[i] = ConvertBits(stack_[i], from, to);
}

void Machine::EvalNode(ExprId expr, const MatrixTruncate& node) {
  const std::size_t base = stack_.size();
  Eval(node.operand);
  const std::size_t from_columns = TypeOf(node.operand).columns;
  const Type& type = TypeOf(expr);
  for (std::size_t r = 0; r < type.rows; ++r) {
    for (std::size_t c = 0; c < type.columns; ++c) {
      stack_[base + r * type.columns + c] = stack_[base + r * from_columns + c];
    }
  }
  stack_.resize(base + type.Components());
}

}  // namespace clipc::ir
