// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/flow.h"

#include <algorithm>

#include "base/overloaded.h"
#include "frontend/rules/constant.h"
#include "frontend/rules/loop_iterations.h"
#include "ir/walk.h"

namespace clipc::check {
namespace {

// Whether a `break` in the statement leaves the loop or switch whose body it is (a `continue` of a
// do-while may leave it, too).
bool Breaks(const Context& context, StmtId id) {
  if (!id) return false;
  return Visit(
      Overloaded{
          [&](const Block& s) {
            return std::ranges::any_of(context[s.body],
                                       [&](StmtId stmt) { return Breaks(context, stmt); });
          },
          [&](const If& s) { return Breaks(context, s.then) || Breaks(context, s.otherwise); },
          [](const Break&) { return true; },
          [](const auto&) { return false; },
      },
      context[id].node);
}

}  // namespace

bool FallsThrough(const Context& context, StmtId id) {
  const auto is_known = [&](ExprId condition, bool value) {
    if (!condition) return value;  // for (;;)
    const auto known = EvaluateInteger(context.program, condition);
    return known && (*known != 0) == value;
  };
  const auto always = [&](ExprId condition) { return is_known(condition, true); };
  return Visit(Overloaded{
                   [&](const Block& s) {
                     return std::ranges::all_of(
                         context[s.body], [&](StmtId stmt) { return FallsThrough(context, stmt); });
                   },
                   [&](const If& s) {
                     if (!is_known(s.condition, false) && FallsThrough(context, s.then))
                       return true;
                     return !always(s.condition) &&
                            (!s.otherwise || FallsThrough(context, s.otherwise));
                   },
                   [&](const For& s) { return !always(s.condition) || Breaks(context, s.body); },
                   [&](const While& s) { return !always(s.condition) || Breaks(context, s.body); },
                   [&](const DoWhile& s) {
                     return (!always(s.condition) && FallsThrough(context, s.body)) ||
                            Breaks(context, s.body);
                   },
                   [&](const Switch& s) {
                     bool falls = true, has_default = false, breaks = false;
                     for (const SwitchCase& arm : context[s.cases]) {
                       falls = true;
                       has_default = has_default || arm.is_default;
                       for (StmtId stmt : context[arm.body]) {
                         falls = falls && FallsThrough(context, stmt);
                         breaks = breaks || Breaks(context, stmt);
                       }
                     }
                     return falls || !has_default || breaks;
                   },
                   [](const Return&) { return false; },
                   [](const Break&) { return false; },
                   [](const Continue&) { return false; },
                   [](const auto&) { return true; },
               },
               context[id].node);
}

bool NeverEnds(const Context& context, StmtId loop) {
  const auto never_ends = [&](ExprId condition, StmtId body) {
    const auto* counted = context.GetIf<For>(loop);
    const auto known = condition ? EvaluateInteger(context.program, condition) : 1;
    const bool holds =
        known.value_or(0) != 0 || (counted && NeverLeaves(context.program, *counted));
    if (!holds || Breaks(context, body)) return false;
    bool returns = false;
    ForEachStmt(context.program, body, [&](StmtId stmt) { returns |= context.Is<Return>(stmt); });
    return !returns;
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
