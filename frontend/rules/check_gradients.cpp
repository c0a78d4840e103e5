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

}  // namespace

void CheckGradients(const Program& program, Diagnostics& diagnostics) {
  if (!InfoOf(program.stage).has_neighbours || program.is_interface_only) return;
  // Without a branch or a loop all pixels of a quad run everything.
  if (!MayHaveStmt<If, Switch, For, While, DoWhile>(program) && !MayHaveExpr<Conditional>(program))
    return;
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
