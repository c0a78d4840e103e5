// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/lower_clip_planes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/check.h"
#include "ir/builder.h"
#include "passes/outputs.h"

namespace clipc::passes {
namespace {

using namespace ir;

// Direct3D 10 and later guarantee 8 clip distances, but [clipplanes] takes as many planes as Direct3D 9 had.
constexpr std::size_t kMaxClipPlanes = 6;

void WriteClipDistances(Program& program) {
  CLIPC_CHECK(!FindOutput(program, Builtin::kClipDistance));
  const VarId position = FindOutput(program, Builtin::kPosition);
  CLIPC_CHECK(position);

  const auto count = static_cast<std::uint32_t>(program.clip_planes.size());
  const TypeId one_distance = program.types.Make(Scalar::kFloat);
  const TypeId distances = program.types.Array(one_distance, count);
  const VarId output = AddOutput(program, Builtin::kClipDistance, "clip_distance", distances);

  std::vector<StmtId> stmts;
  for (std::uint32_t i = 0; i < count; ++i) {
    const ClipPlane& plane = program.clip_planes[i];
    CLIPC_CHECK(plane.value);
    Builder b(program, plane.span);
    ExprId distance =
        b.IntrinsicOf(Intrinsic::kDot, one_distance, {b.Ref(position), plane.value});
    stmts.push_back(b.Eval(b.AssignTo(b.At(b.Ref(output), i), distance)));
  }
  AppendToBody(program, program.main, stmts);
}

void WriteClipVertex(Program& program) {
  const VarId position = FindOutput(program, Builtin::kPosition);
  CLIPC_CHECK(position);
  const VarId output =
      AddOutput(program, Builtin::kClipVertex, "clip_vertex", program.vars[position].type);
  Builder b(program, program.clip_planes.front().span);
  AppendToBody(program, program.main, std::array{b.Eval(b.AssignTo(b.Ref(output), b.Ref(position)))});
}

}  // namespace

void LowerClipPlanes(Program& program, const ClipPlaneOptions& options) {
  CLIPC_CHECK(program.form == Form::kTyped);
  CLIPC_CHECK(program.clip_planes.size() <= kMaxClipPlanes);
  if (!program.clip_planes.empty()) {
    switch (options.lowering) {
      case Lowering::kClipDistance: WriteClipDistances(program); break;
      case Lowering::kLevel9:
        if (options.write_clip_vertex) WriteClipVertex(program);
        break;
      case Lowering::kNone: break;
    }
  }
  for (ClipPlane& plane : program.clip_planes) plane.value = {};
  program.form = Form::kNoClipPlanes;
}

}  // namespace clipc::passes
