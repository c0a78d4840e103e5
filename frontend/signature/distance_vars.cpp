// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/distance_vars.h"

#include <algorithm>

#include "base/spelling.h"

namespace clipc::signature {

ExprId DistanceVars::Read(const Carrier& leaf, Builtin builtin) {
  const std::uint32_t count = program_.types[leaf.type].Components();
  if (!IsDistance(leaf)) return {};
  std::vector<ExprId> values;
  for (std::uint32_t i = 0; i < count; ++i) values.push_back(builder_.Float(0));
  auto& pieces = builtin == Builtin::kClipDistanceInput ? clip_reads_ : cull_reads_;
  pieces.Add(leaf.cursor.semantic.index, values, leaf.span);
  const TypeId vector = program_.types.Vector(Scalar::kFloat, static_cast<int>(count));
  return Fit(program_, builder_, count == 1 ? values.front() : builder_.ConstructOf(vector, values),
             leaf.type);
}

void DistanceVars::FinishReads() {
  const bool has_gaps = FitWithGaps(clip_reads_, cull_reads_);
  ReadKind(Builtin::kClipDistanceInput, clip_reads_, has_gaps);
  ReadKind(Builtin::kCullDistanceInput, cull_reads_, has_gaps);
}

void DistanceVars::ReadKind(Builtin builtin, Distances& pieces, bool has_gaps) {
  if (pieces.empty()) return;
  const std::vector<ExprId> values = pieces.Packed(has_gaps);
  const VarId array = vars_.AddDistances(builtin, pieces, values);
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    const ExprId element = builder_.At(builder_.Ref(array), i);
    if (values[i]) program_.exprs[values[i]].node = program_.exprs[element].node;
  }
}

void DistanceVars::Write(std::vector<StmtId>& body) {
  const bool has_gaps = FitWithGaps(clip_, cull_);
  WriteKind(Builtin::kClipDistance, clip_, has_gaps, body);
  WriteKind(Builtin::kCullDistance, cull_, has_gaps, body);
  clip_ = cull_ = {};
}

void DistanceVars::WriteKind(Builtin builtin, Distances& pieces, bool has_gaps,
                             std::vector<StmtId>& body) {
  if (pieces.empty()) return;
  const std::vector<ExprId> values = pieces.Packed(has_gaps);
  const VarId array = vars_.AddDistances(builtin, pieces, values);
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    const ExprId value = values[i] ? values[i] : builder_.Float(0);
    body.push_back(builder_.Eval(builder_.AssignTo(builder_.At(builder_.Ref(array), i), value)));
  }
}

ExprId DistanceVars::ReadPoint(const Carrier& leaf, std::uint32_t point) {
  const SemanticName& semantic = leaf.cursor.semantic;
  const std::uint32_t count = program_.types[leaf.type].Components();
  for (const DistancePiece& piece : program_.distances) {
    const auto written = std::ranges::find(program_.outputs, piece.array, &IoVar::var);
    if (written == program_.outputs.end() || piece.index != semantic.index || piece.count < count ||
        !EqualIgnoringCase(semantic.name, written->semantic))
      continue;
    std::vector<ExprId> values;
    for (std::uint32_t i = 0; i < count; ++i) {
      const ExprId array =
          builder_.IntrinsicOf(CommonIntrinsic::kOutputOfPoint, program_.vars[piece.array].type,
                               {builder_.Ref(piece.array), builder_.Uint(point)});
      values.push_back(builder_.At(array, piece.first + i));
    }
    const TypeId vector = program_.types.Vector(Scalar::kFloat, static_cast<int>(count));
    return Fit(program_, builder_,
               count == 1 ? values.front() : builder_.ConstructOf(vector, values), leaf.type);
  }
  return {};
}

bool DistanceVars::IsDistance(const Carrier& leaf) {
  if (BaseOf(program_.types[leaf.type].scalar) == Scalar::kFloat) return true;
  semantics_.Refuse(leaf, "a `float` scalar or vector");
  return false;
}

}  // namespace clipc::signature
