// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/check_gradients.h"

#include "frontend/rules/varying_flow.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

// Whether the input may have several values in the four pixels of a quad, all of one primitive.
bool DiffersInQuad(const Program& program, const IoVar& input) {
  switch (input.builtin) {
    case Builtin::kNone:
      return input.interpolation != Interpolation::kNoInterpolation &&
             IsFloat(program.types[program.vars[input.var].type].scalar);
    case Builtin::kPixelPosition:
    case Builtin::kCoverageInput:
    case Builtin::kBarycentrics:
    case Builtin::kBarycentricsNoPerspective:
    case Builtin::kClipDistanceInput:
    case Builtin::kCullDistanceInput: return true;
    default: return false;
  }
}

bool ChangesInOneStep(const Program& program, ExprId expr) {
  const auto* object = As<ObjectCall>(program, expr);
  return object && IsAtomic(object->op);
}

bool IsGradient(const Program& program, ExprId expr) {
  const auto* call = As<IntrinsicCall>(program, expr);
  const bool is_quad = call && CategoryOf(call->op) == IntrinsicCategory::kQuad;
  return AsksNeighbours(program, expr) && !is_quad;
}

bool IsGradientOrCall(const Program& program, ExprId expr) {
  return As<Call>(program, expr) || IsGradient(program, expr);
}

// Whether the statement has a gradient, or a call of a function that may have one, where some
// pixels may not come to, as a short look tells: in a branch or a loop, or after a `return` there.
bool MayVary(const Program& program, StmtId id, bool is_inside) {
  const auto& node = program.stmts[id].node;
  if (std::holds_alternative<Return>(node) && is_inside) return true;
  is_inside = is_inside || std::holds_alternative<If>(node) ||
              std::holds_alternative<Switch>(node) || std::holds_alternative<For>(node) ||
              std::holds_alternative<While>(node) || std::holds_alternative<DoWhile>(node);
  bool may_vary = false;
  ForEachPart(
      program, id,
      [&](ExprId root) {
        may_vary = may_vary || (is_inside && AnyExpr(program, root, [&](ExprId expr) {
                                  return IsGradientOrCall(program, expr);
                                }));
      },
      [&](StmtId part) { may_vary = may_vary || MayVary(program, part, is_inside); });
  return may_vary;
}

// The same for the sides of a choice.
bool MayVary(const Program& program) {
  const auto may_ask = [&](ExprId side) {
    return !side || AnyExpr(program, side,
                            [&](ExprId expr) { return !expr || IsGradientOrCall(program, expr); });
  };
  return MayHaveExpr<Conditional>(program,
                                  [&](const Conditional& choice) {
                                    return may_ask(choice.when_true) || may_ask(choice.when_false);
                                  }) ||
         program.functions.AnyOf([&](const Function& function) {
           return function.body && MayVary(program, function.body, false);
         });
}

}  // namespace

void CheckGradients(const Program& program, Diagnostics& diagnostics) {
  if (!InfoOf(program.stage).has_neighbours || program.is_interface_only) return;
  if (!MayVary(program)) return;
  for (const AskedNode& node : FollowFlow(program, {DiffersInQuad, ChangesInOneStep, IsGradient})) {
    // What is the same for all pixels of a quad has differences of 0 in any flow.
    if (!node.value_varies) continue;
    const char* what = As<IntrinsicCall>(program, node.expr) ? "a derivative" : "a sample";
    const Span span = program.exprs[node.expr].span;
    if (node.loop_varies)
      diagnostics.Report(span, diag::GradientInLoop, what);
    else if (node.flow_varies)
      diagnostics.Report(span, diag::GradientInBranch, what);
  }
}

}  // namespace clipc::rules
