// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/flow.h"

#include <optional>

#include "base/overloaded.h"
#include "frontend/rules/loop_iterations.h"
#include "frontend/typing/constant.h"
#include "ir/walk.h"

namespace clipc::check {
namespace {

// What a condition is, as far as it is known.
struct Condition {
  bool may_hold = true, may_fail = true;
};

class Flow {
 public:
  explicit Flow(const Program& program) : program_(program) {}

  Exits Of(StmtId id) const {
    if (!id) return {.falls = true};
    return Visit([&](const auto& node) { return Of(node); }, program_.stmts[id].node);
  }

 private:
  Condition Known(ExprId condition) const {
    if (!condition) return {.may_fail = false};  // for (;;)
    const auto known = typing::EvaluateInteger(program_, condition);
    if (!known) return KnownOfSides(condition);
    return {.may_hold = *known != 0, .may_fail = *known == 0};
  }

  // One side of `&&` or `||` may decide.
  Condition KnownOfSides(ExprId condition) const {
    const auto* binary = As<Binary>(program_, condition);
    if (!binary) return {};
    const bool is_and =
        binary->op == BinaryOp::kLogicalAnd || binary->op == BinaryOp::kShortCircuitAnd;
    const bool is_or =
        binary->op == BinaryOp::kLogicalOr || binary->op == BinaryOp::kShortCircuitOr;
    if (!is_and && !is_or) return {};
    const Condition left = Known(binary->left), right = Known(binary->right);
    return is_and ? Condition{.may_hold = left.may_hold && right.may_hold}
                  : Condition{.may_fail = left.may_fail && right.may_fail};
  }

  Exits OfList(List<StmtId> list) const {
    Exits all{.falls = true};
    for (std::uint32_t i = 0; i < list.size && all.falls; ++i) {
      const Exits one = Of(program_.stmt_lists[list][i]);
      all.falls = one.falls;
      Add(all, one);
    }
    return all;
  }
  // Adds the jumps of a part.
  static void Add(Exits& all, const Exits& part) {
    all.breaks |= part.breaks;
    all.continues |= part.continues;
    all.returns |= part.returns;
  }

  Exits Of(const Block& node) const { return OfList(node.body); }
  Exits Of(const If& node) const {
    const Condition condition = Known(node.condition);
    const Exits then = condition.may_hold ? Of(node.then) : Exits{};
    Exits all = condition.may_fail ? Of(node.otherwise) : Exits{};
    all.falls |= then.falls;
    Add(all, then);
    return all;
  }
  Exits Of(const For& node) const { return OfLoop(node.condition, node.body); }
  Exits Of(const While& node) const { return OfLoop(node.condition, node.body); }
  Exits OfLoop(ExprId condition, StmtId body) const {
    const Condition known = Known(condition);
    const Exits inner = known.may_hold ? Of(body) : Exits{};
    return {.falls = known.may_fail || inner.breaks, .returns = inner.returns};
  }
  Exits Of(const DoWhile& node) const {
    const Exits inner = Of(node.body);
    const bool reaches_condition = inner.falls || inner.continues;
    const bool ends = reaches_condition && Known(node.condition).may_fail;
    return {.falls = ends || inner.breaks, .returns = inner.returns};
  }
  Exits Of(const Switch& node) const {
    const auto value = typing::EvaluateInteger(program_, node.value);
    const auto cases = program_.switch_cases[node.cases];
    bool has_default = false, has_label = false;
    for (const SwitchCase& arm : cases) {
      has_default |= arm.is_default;
      has_label |= value && HasLabel(arm, *value);
    }
    Exits all{.falls = !has_default && !has_label};
    bool falls = false;  // out of the arm before
    for (const SwitchCase& arm : cases) {
      const bool is_chosen = !value || (has_label ? HasLabel(arm, *value) : arm.is_default);
      if (!is_chosen && !falls) continue;
      const Exits one = OfList(arm.body);
      falls = one.falls;
      Add(all, one);
    }
    all.falls |= falls || std::exchange(all.breaks, false);
    return all;
  }
  bool HasLabel(const SwitchCase& arm, std::int64_t value) const {
    for (std::uint32_t i = 0; i < arm.labels.size; ++i) {
      if (typing::EvaluateInteger(program_, program_.expr_lists[arm.labels][i]) == value)
        return true;
    }
    return false;
  }
  Exits Of(const Return&) const { return {.returns = true}; }
  Exits Of(const Break&) const { return {.breaks = true}; }
  Exits Of(const Continue&) const { return {.continues = true}; }
  // A discard leaves no function.
  Exits Of(const OneOf<Declare, Evaluate, Discard> auto&) const { return {.falls = true}; }

  const Program& program_;
};

}  // namespace

Exits ExitsOf(const Program& program, StmtId id) { return Flow(program).Of(id); }

bool NeverEnds(const Context& context, StmtId loop) {
  const auto never_ends = [&](ExprId condition, StmtId body) {
    const auto* counted = context.GetIf<For>(loop);
    const auto known = condition ? EvaluateInteger(context.program, condition) : 1;
    const bool holds =
        known.value_or(0) != 0 || (counted && NeverLeaves(context.program, *counted));
    if (!holds) return false;
    const Exits inner = ExitsOf(context.program, body);
    return !inner.breaks && !inner.returns;
  };
  return Visit(Overloaded{
                   [&](const OneOf<For, While, DoWhile> auto& node) {
                     return never_ends(node.condition, node.body);
                   },
                   [](const auto&) { return false; },
               },
               context[loop].node);
}

}  // namespace clipc::check
