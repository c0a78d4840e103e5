// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/written_walk.h"

#include <algorithm>
#include <utility>

#include "base/overloaded.h"
#include "frontend/rules/written_messages.h"
#include "frontend/typing/constant.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::rules {
// ---- expressions

void WrittenWalk::Visit(ExprId expr) {
  clipc::Visit(
      Overloaded{
          [&](const OneOf<VarRef, FieldRef, Index, Swizzle, MatrixSwizzle> auto&) {
            if (VisitTarget(expr) && TypeOf(program_, expr).IsNumeric()) CheckRead(expr);
          },
          [&](const Unary& node) {
            Visit(node.operand);
            if (!ChangesOperand(node.op)) return;
            WriteTo(node.operand, {});
          },
          [&](const Assign& node) { shared_.values.Check(node), VisitAssign(node); },
          [&](const Call& node) { VisitCall(expr, node); },
          [&](const Conditional& node) {
            Visit(node.condition);
            const auto known = EvaluateInteger(program_, node.condition);
            if (known.value_or(1) != 0) VisitChoice(node.when_true);
            if (known.value_or(0) == 0) VisitChoice(node.when_false);
          },
          [&](const Select& node) {
            Visit(node.condition);
            VisitChoice(node.when_true);
            VisitChoice(node.when_false);
          },
          [&](const Binary& node) {
            shared_.values.Check(node);
            Visit(node.left);
            // The right side of && and || may not matter.
            if (IsLogical(node.op))
              VisitChoice(node.right);
            else
              Visit(node.right);
          },
          [&](const IntrinsicCall& node) { shared_.values.Check(node), VisitIntrinsic(node); },
          [&](const ObjectCall& node) {
            ForEachNamedOperand(program_, node, [&](OperandKind kind, ExprId operand) {
              if (kind == OperandKind::kTexel)
                WriteTo(operand, {});
              else
                Visit(operand);
            });
          },
          [&]<typename Node>(const Node& node) {
            ForEachSlot(
                node, [&](ExprId operand) { Visit(operand); },
                [&](List<ExprId> list) {
                  for (const ExprId operand : program_.expr_lists[list]) Visit(operand);
                });
          },
      },
      program_.exprs[expr].node);
}

// Visits a part whose value a condition may discard.
void WrittenWalk::VisitChoice(ExprId expr) {
  ++choices_;
  Visit(expr);
  --choices_;
}

// Visits the indices of a path, and what it is a part of if that is not a variable. Returns whether
// it is a variable that is tracked.
bool WrittenWalk::VisitTarget(ExprId path) {
  return clipc::Visit(Overloaded{
                          [&](const VarRef& node) { return shared_.slots.IsTracked(node.var); },
                          [&](const OneOf<FieldRef, Swizzle, MatrixSwizzle> auto& node) {
                            return VisitTarget(node.base);
                          },
                          [&](const Index& node) {
                            const bool is_tracked = VisitTarget(node.base);
                            Visit(node.index);
                            return is_tracked;
                          },
                          [&](const auto&) { return Visit(path), false; },
                      },
                      program_.exprs[path].node);
}

void WrittenWalk::VisitAssign(const Assign& node) {
  if (IsMain()) CheckOutput(node);
  VisitTarget(node.target);
  if (!node.op && !IsOfOwnTemporary(node)) return WriteTo(node.target, ValueOf(node.value));
  Visit(node.value);
  if (!node.op) return WriteTo(node.target, {});
  if (TypeOf(program_, node.target).IsNumeric()) CheckRead(node.target);
  WriteTo(node.target, {});
}

// Whether the assignment gives a number to a variable that clipc made for it, which is at the same
// place. Its value is read here, so that a message names what the text names.
bool WrittenWalk::IsOfOwnTemporary(const Assign& node) const {
  const auto* target = As<VarRef>(program_, node.target);
  return target && program_.vars[target->var].span == program_.exprs[node.target].span &&
         TypeOf(program_, node.target).IsNumeric();
}

void WrittenWalk::VisitIntrinsic(const IntrinsicCall& node) {
  std::size_t i = 0;
  for (const ExprId argument : program_.expr_lists[node.arguments]) {
    if (!WritesArgument(node.op, i++)) {
      Visit(argument);
      continue;
    }
    VisitTarget(argument);
    WriteTo(argument, {});
  }
}

void WrittenWalk::VisitCall(ExprId expr, const Call& node) {
  const WrittenSummary& summary = shared_.summaries[node.function.index];
  const bool is_of_entry = IsCalledByMain(node.function);
  std::size_t i = 0;
  KeptVector<std::pair<ExprId, std::size_t>> written;
  ForEachOperand(program_, expr, [&](ExprId argument) {
    const std::size_t number = i++;
    if (!WritesOperand(program_, expr, number)) return Visit(argument);
    VisitTarget(argument);
    written.emplace_back(argument, number);
  });
  for (const auto& [target, number] : written) {
    WriteTo(target, is_of_entry ? std::span<const WrittenComponents>(summary.parameters[number])
                                : std::span<const WrittenComponents>());
  }
}

KeptVector<WrittenComponents> WrittenWalk::ValueOf(ExprId value) {
  const bool is_numeric = TypeOf(program_, value).IsNumeric();
  if (const auto* call = As<Call>(program_, value)) {
    Visit(value);
    return shared_.summaries[call->function.index].result;
  }
  std::optional<WrittenPlace> place;
  if (!is_numeric || As<VarRef>(program_, value)) place = shared_.slots.Find(value);
  const bool is_return = IsEntry() || !is_numeric;
  if (!place || place->is_coarse || !is_return) {
    Visit(value);
    return {};
  }
  VisitTarget(value);
  KeptVector<WrittenComponents> values;
  for (std::size_t i = 0; i < place->count; ++i) values.push_back(state_[place->first + i]);
  return values;
}

void WrittenWalk::Track(VarId var) {
  shared_.slots.Track(var);
  state_.Grow(shared_.slots.size());
}

// Makes a variable what it is where it is declared without a value.
void WrittenWalk::Unwrite(VarId var) {
  Track(var);
  if (!shared_.slots.IsTracked(var)) return;
  const WrittenPlace place = shared_.slots.Whole(var);
  for (std::size_t i = 0; i < place.count; ++i) state_.Declare(place.first + i, loops_);
}

// Gives the values to a path; no values: it is written.
void WrittenWalk::WriteTo(ExprId target, std::span<const WrittenComponents> values) {
  const VarId root = AreAllWritten(values) ? VarId{} : RootOf(program_, target);
  if (root) Track(root);
  if (const auto place = shared_.slots.Find(target)) Write(*place, values);
}

void WrittenWalk::Write(const WrittenPlace& place, std::span<const WrittenComponents> values) {
  if (place.count == 1 && (place.is_coarse || values.size() != 1))
    return state_.Add(place.first, place.mask);
  for (std::size_t i = 0; i < place.count; ++i)
    state_.Set(place.first + i, values.size() == place.count ? values[i] : kAllWritten);
}

void WrittenWalk::CheckRead(ExprId path) {
  if (IsMain()) return;  // CheckOutput has a message of its own
  const auto place = shared_.slots.Find(path);
  if (!place || place->count != 1 || place->mask == 0) return;
  if (shared_.is_reported[place->var.index]) return;
  const WrittenComponents& written = state_[place->first];
  if (written.may & place->mask) {
    // An index that varies may choose what is written.
    const bool may_choose = place->is_coarse && (written.safe & place->mask) != 0;
    if (may_choose || !state_.UnsafeAt(place->first, place->mask, {loops_, choices_})) return;
    shared_.is_reported[place->var.index] = true;
    return ReportPartlyRead(program_.exprs[path].span, program_.vars[place->var],
                            shared_.diagnostics);
  }
  const Read read{*place, program_.exprs[path].span};
  if (loops_ == 0) return Report(read);
  // One read of a slot is enough.
  const bool is_known = !reads_.empty() && reads_.back().place.first == place->first &&
                        reads_.back().place.mask == place->mask;
  if (!is_known) reads_.push_back(read);
}

void WrittenWalk::Report(const Read& read) {
  if (shared_.is_reported[read.place.var.index]) return;
  shared_.is_reported[read.place.var.index] = true;
  ReportRead(read.span, program_.vars[read.place.var], shared_.diagnostics);
}

// ---- main

void WrittenWalk::CheckOutput(const Assign& node) {
  const auto* element = As<Index>(program_, node.target);
  const auto* target = As<VarRef>(program_, element ? element->base : node.target);
  IoVar* output = target ? shared_.outputs[target->var.index] : nullptr;
  ExprId value = node.value;
  // Direct3D 9 clamps colors, and [maxtessfactor] the factors of a patch.
  if (const auto* call = As<IntrinsicCall>(program_, value);
      call && (call->op == CommonIntrinsic::kSaturate || call->op == CommonIntrinsic::kMin))
    value = program_.expr_lists[call->arguments][0];
  const auto place = output ? shared_.slots.Find(value) : std::nullopt;
  if (!place || place->count != 1) return;
  const WrittenComponents& written = state_[place->first];
  if (!element) output->is_unwritten = (written.may & place->mask) == 0;
  if ((written.may & written.must & place->mask) == place->mask) return;
  output->may_be_unwritten = true;
  const auto number = element ? EvaluateInteger(program_, element->index) : std::nullopt;
  ReportOutput(program_, {*output, number}, {written, place->mask}, shared_.diagnostics);
}

}  // namespace clipc::rules
