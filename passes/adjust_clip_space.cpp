// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/adjust_clip_space.h"

#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "passes/outputs.h"

namespace clipc::passes {

using namespace ir;

void AdjustClipSpace(Program& program, const ClipSpaceOptions& options) {
  CLIPC_CHECK(program.form == Form::kNoClipPlanes);
  program.form = Form::kTargetClipSpace;
  const VarId position = FindOutput(program, Builtin::kPosition);
  if (!position) return;  // legal: a stage after the vertex shader writes it
  // Control points are not drawn.
  if (clipc::InfoOf(program.stage).makes_patches) return;

  Builder b(program);
  const auto component = [&](int index) { return b.Swizzled(b.Ref(position), {index}); };
  const auto y = [&] { return component(1); };
  const auto z = [&] { return component(2); };
  const auto w = [&] { return component(3); };

  std::vector<StmtId> stmts;
  if (options.flip_y) {
    stmts.push_back(b.Eval(b.AssignTo(y(), b.UnaryOf(UnaryOp::kNegate, y()))));
  }
  if (options.negative_one_to_one) {
    // Doubling is exact, so this rounds once, with or without a fused multiply-add.
    ExprId twice_z = b.BinaryOf(BinaryOp::kMul, b.Float(2), z());
    stmts.push_back(b.Eval(b.AssignTo(z(), b.BinaryOf(BinaryOp::kSub, twice_z, w()))));
  }
  AppendToOutputs(program, stmts);
}

}  // namespace clipc::passes
