// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/lower_clip_planes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "passes/outputs.h"

namespace clipc::passes {
namespace {

using namespace ir;

VarId PositionOf(const Program& program) {
  const VarId position = FindOutput(program, Builtin::kPosition);
  CLIPC_CHECK(position);
  return position;
}

// The expression float4(xyz, 1).
ExprId WithOne(Program& program, Builder& b, ExprId xyz) {
  return b.ConstructOf(program.types.Vector(Scalar::kFloat, 4), {xyz, b.Float(1)});
}

// The vector that the planes are dotted with.
class Vertex {
 public:
  // Adds to `stmts` the statements that must come before the first distance.
  Vertex(Program& program, const ClipPlaneOptions& options, std::vector<StmtId>& stmts)
      : program_(program), var_(options.position_input) {
    if (options.space != PlaneSpace::kObject) {
      var_ = PositionOf(program);
      local_ = LocalWrittenTo(program, var_);
    }
    CLIPC_CHECK(var_);
    if (options.space == PlaneSpace::kXyw1) MakeXyw1(stmts);
  }

  // The expression dot(vertex, plane).
  ExprId DistanceTo(const ClipPlane& plane) const {
    CLIPC_CHECK(plane.value);
    Builder b(program_, plane.span);
    return b.IntrinsicOf(CommonIntrinsic::kDot, program_.types.Make(Scalar::kFloat),
                         {Value(b), plane.value});
  }

 private:
  // Adds `float4 xyw1 = position.xyww; xyw1.w = 1;` to `stmts`. This is two instructions of SPIR-V;
  // float4(position.xyw, 1) would be four.
  void MakeXyw1(std::vector<StmtId>& stmts) {
    Builder b(program_, program_.clip_planes.front().span);
    const VarId xyw1 = b.Local("xyw1", program_.vars[var_].type);
    const ExprId position = local_ ? Clone(program_, local_) : b.Ref(var_);
    stmts.push_back(b.Stmt(Declare{xyw1, b.Swizzled(position, {0, 1, 3, 3})}));
    const ExprId w = b.Swizzled(b.Ref(xyw1), {3});
    stmts.push_back(b.Eval(b.AssignTo(w, b.Float(1))));
    var_ = xyw1;
    local_ = {};
  }

  ExprId Value(Builder& b) const {
    const ExprId vertex = local_ ? Clone(program_, local_) : b.Ref(var_);
    const Type& type = program_.types[program_.vars[var_].type];
    CLIPC_CHECK(type.scalar == Scalar::kFloat &&
                (type.Components() == 3 || type.Components() == 4));
    return type.Components() == 3 ? WithOne(program_, b, vertex) : vertex;
  }

  Program& program_;
  VarId var_;
  ExprId local_;  // the local variable or field that `var_` is a copy of; may be none
};

void WriteClipDistances(Program& program, const ClipPlaneOptions& options) {
  CLIPC_CHECK(!FindOutput(program, Builtin::kClipDistance));
  const auto count = static_cast<std::uint32_t>(program.clip_planes.size());
  const TypeId one_distance = program.types.Make(Scalar::kFloat);
  const TypeId distances = program.types.Array(one_distance, count);
  const VarId output = AddOutput(program, Builtin::kClipDistance, "clip_distance", distances);

  std::vector<StmtId> stmts;
  const Vertex vertex(program, options, stmts);
  for (std::uint32_t i = 0; i < count; ++i) {
    const ClipPlane& plane = program.clip_planes[i];
    Builder b(program, plane.span);
    stmts.push_back(b.Eval(b.AssignTo(b.At(b.Ref(output), i), vertex.DistanceTo(plane))));
  }
  AppendToOutputs(program, stmts);
}

void WriteClipVertex(Program& program) {
  const VarId position = PositionOf(program);
  const VarId output =
      AddOutput(program, Builtin::kClipVertex, "clip_vertex", program.vars[position].type);
  Builder b(program, program.clip_planes.front().span);
  AppendToOutputs(program, std::array{b.Eval(b.AssignTo(b.Ref(output), b.Ref(position)))});
}

void WriteDepth(Program& program, const ClipPlaneOptions& options) {
  CLIPC_CHECK(program.clip_planes.size() == 1);
  const VarId position = PositionOf(program);
  const ClipPlane& plane = program.clip_planes.front();
  Builder b(program, plane.span);
  std::vector<StmtId> stmts;
  const Vertex vertex(program, options, stmts);
  const ExprId local = LocalWrittenTo(program, position);
  const ExprId depth = b.Swizzled(local ? Clone(program, local) : b.Ref(position), {2});
  stmts.push_back(b.Eval(b.AssignTo(depth, vertex.DistanceTo(plane))));
  if (local) {
    // The depth changes before the position is written, which is then written once.
    stmts.push_back(b.Eval(b.AssignTo(b.Ref(position), Clone(program, local))));
    RemoveWrite(program, position);
  }
  AppendToOutputs(program, stmts);
}

void WriteVaryings(Program& program, const ClipPlaneOptions& options) {
  const std::size_t count = program.clip_planes.size();
  std::vector<StmtId> stmts;
  const Vertex vertex(program, options, stmts);
  for (std::size_t first = 0; first < count; first += 4) {
    const auto width = static_cast<int>(std::min<std::size_t>(count - first, 4));
    const VarId output =
        AddOutput(program, Builtin::kNone, "clip_plane_distance" + std::to_string(first / 4),
                  width == 1 ? program.types.Make(Scalar::kFloat)
                             : program.types.Vector(Scalar::kFloat, width));
    program.outputs.back().semantic = kClipPlaneDistance;
    program.outputs.back().index = static_cast<std::uint32_t>(first / 4);
    std::vector<ExprId> distances;
    for (int i = 0; i < width; ++i) {
      distances.push_back(
          vertex.DistanceTo(program.clip_planes[first + static_cast<std::size_t>(i)]));
    }
    Builder b(program, program.clip_planes[first].span);
    const ExprId value =
        width == 1 ? distances.front() : b.ConstructOf(program.vars[output].type, distances);
    stmts.push_back(b.Eval(b.AssignTo(b.Ref(output), value)));
  }
  AppendToOutputs(program, stmts);
}

}  // namespace

void LowerClipPlanes(Program& program, const ClipPlaneOptions& options) {
  CLIPC_CHECK(program.form == Form::kResolved);
  CLIPC_CHECK(program.clip_planes.size() <= kMaxClipPlanes);
  CLIPC_CHECK(Supports(options.lowering, options.space));
  if (!program.clip_planes.empty()) {
    switch (options.lowering) {
      case Lowering::kClipDistance: WriteClipDistances(program, options); break;
      case Lowering::kLevel9:
        if (options.write_clip_vertex) WriteClipVertex(program);
        break;
      case Lowering::kNone: break;
      case Lowering::kNearPlane: WriteDepth(program, options); break;
      case Lowering::kDiscard: WriteVaryings(program, options); break;
    }
  }
  for (ClipPlane& plane : program.clip_planes) plane.value = {};
  program.form = Form::kNoClipPlanes;
}

}  // namespace clipc::passes
