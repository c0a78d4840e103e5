// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/lower_clip_planes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/check.h"
#include "ir/builder.h"
#include "passes/outputs.h"

namespace clipc::passes {
namespace {

using namespace ir;

// Direct3D 10 and later guarantee 8 clip distances, but [clipplanes] takes as many planes as Direct3D 9 had.
constexpr std::size_t kMaxClipPlanes = 6;

VarId PositionOf(const Program& program) {
  const VarId position = FindOutput(program, Builtin::kPosition);
  CLIPC_CHECK(position);
  return position;
}

// dot(position, plane)
ExprId DistanceTo(Program& program, VarId position, const ClipPlane& plane) {
  CLIPC_CHECK(plane.value);
  Builder b(program, plane.span);
  return b.IntrinsicOf(Intrinsic::kDot, program.types.Make(Scalar::kFloat), {b.Ref(position), plane.value});
}

void WriteClipDistances(Program& program) {
  CLIPC_CHECK(!FindOutput(program, Builtin::kClipDistance));
  const VarId position = PositionOf(program);
  const auto count = static_cast<std::uint32_t>(program.clip_planes.size());
  const TypeId one_distance = program.types.Make(Scalar::kFloat);
  const TypeId distances = program.types.Array(one_distance, count);
  const VarId output = AddOutput(program, Builtin::kClipDistance, "clip_distance", distances);

  std::vector<StmtId> stmts;
  for (std::uint32_t i = 0; i < count; ++i) {
    const ClipPlane& plane = program.clip_planes[i];
    Builder b(program, plane.span);
    stmts.push_back(b.Eval(b.AssignTo(b.At(b.Ref(output), i), DistanceTo(program, position, plane))));
  }
  AppendToBody(program, program.main, stmts);
}

void WriteClipVertex(Program& program) {
  const VarId position = PositionOf(program);
  const VarId output =
      AddOutput(program, Builtin::kClipVertex, "clip_vertex", program.vars[position].type);
  Builder b(program, program.clip_planes.front().span);
  AppendToBody(program, program.main, std::array{b.Eval(b.AssignTo(b.Ref(output), b.Ref(position)))});
}

void WriteDepth(Program& program) {
  CLIPC_CHECK(program.clip_planes.size() == 1);
  const VarId position = PositionOf(program);
  const ClipPlane& plane = program.clip_planes.front();
  Builder b(program, plane.span);
  ExprId depth = b.Swizzled(b.Ref(position), {2});
  AppendToBody(program, program.main, std::array{b.Eval(b.AssignTo(depth, DistanceTo(program, position, plane)))});
}

void WriteVaryings(Program& program) {
  const VarId position = PositionOf(program);
  const std::size_t count = program.clip_planes.size();
  std::vector<StmtId> stmts;
  for (std::size_t first = 0; first < count; first += 4) {
    const auto width = static_cast<int>(std::min<std::size_t>(count - first, 4));
    const VarId output = AddOutput(program, Builtin::kNone, "clip_plane_distance" + std::to_string(first / 4),
                                   width == 1 ? program.types.Make(Scalar::kFloat) : program.types.Vector(Scalar::kFloat, width));
    program.outputs.back().semantic = kClipPlaneDistance;
    program.outputs.back().index = static_cast<std::uint32_t>(first / 4);
    for (int i = 0; i < width; ++i) {
      const ClipPlane& plane = program.clip_planes[first + static_cast<std::size_t>(i)];
      Builder b(program, plane.span);
      ExprId distance = width == 1 ? b.Ref(output) : b.Swizzled(b.Ref(output), {i});
      stmts.push_back(b.Eval(b.AssignTo(distance, DistanceTo(program, position, plane))));
    }
  }
  AppendToBody(program, program.main, stmts);
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
      case Lowering::kNearPlane: WriteDepth(program); break;
      case Lowering::kDiscard: WriteVaryings(program); break;
    }
  }
  for (ClipPlane& plane : program.clip_planes) plane.value = {};
  program.form = Form::kNoClipPlanes;
}

}  // namespace clipc::passes
