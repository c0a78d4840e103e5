// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/patch_outputs.h"

#include <algorithm>
#include <string_view>

#include "base/spelling.h"

namespace clipc::signature {

ExprId PatchOutputs::ReadPoint(const Carrier& leaf, std::uint32_t point, DistanceVars& distances) {
  if (const ExprId known = distances.ReadPoint(leaf, point)) return known;
  const SemanticName& semantic = leaf.cursor.semantic;
  const auto written = std::ranges::find_if(program_.outputs, [&](const IoVar& output) {
    return !output.is_of_patch && output.index == semantic.index &&
           EqualIgnoringCase(output.semantic, semantic.name);
  });
  const bool is_known = written != program_.outputs.end() &&
                        program_.types[program_.vars[written->var].type].IsScalarOrVector();
  if (!is_known) {
    if (point == 0)
      diagnostics_.Report(leaf.span, diag::PatchOutputUnknown, leaf.name, semantic.name,
                          semantic.index);
    return {};
  }
  const TypeId type = program_.vars[written->var].type;
  ExprId value = builder_.IntrinsicOf(CommonIntrinsic::kOutputOfPoint, type,
                                      {builder_.Ref(written->var), builder_.Uint(point)});
  const std::uint32_t count = program_.types[leaf.type].Components();
  if (count < program_.types[type].Components()) value = builder_.SwizzledRun(value, 0, count);
  return Fit(program_, builder_, value, leaf.type);
}

std::vector<Carrier> PatchOutputs::PassOn(const Carrier& patch, SignatureLeaves& leaves,
                                          std::vector<StmtId>& body) {
  if (program_.types[patch.type].count < program_.tessellation.output_points) return {};
  constexpr auto kNumber = Builtin::kControlPointId;
  auto number = std::ranges::find(program_.inputs, kNumber, &IoVar::builtin);
  if (number == program_.inputs.end()) {
    vars_.AddInput(patch, TypeOf(program_.types, kNumber), kNumber);
    number = program_.inputs.end() - 1;
    number->semantic = "SV_OutputControlPointID", number->index = 0;
  }
  Carrier point = patch;
  point.type = program_.types[patch.type].element;
  const VarId local = builder_.Local("point", point.type);
  body.push_back(builder_.Stmt(
      Declare{local, builder_.At(leaves.ValueOf(patch.part), builder_.Ref(number->var))}));
  point.part = leaves.Whole(local);
  return {point};
}

void PatchOutputs::AddFactor(const Carrier& leaf, Builtin builtin, ExprId value) {
  const Type type = program_.types[leaf.type];
  if (type.Components() != 1 || BaseOf(type.scalar) != Scalar::kFloat) {
    is_refused_ = true;
    return semantics_.Refuse(leaf, "a `float` or an array of it");
  }
  std::vector<Factor>& factors = builtin == Builtin::kTessFactor ? outer_ : inside_;
  factors.push_back(
      {leaf.cursor.semantic.index, builder_.ConvertTo(Scalar::kFloat, value), leaf.span});
}

std::vector<StmtId> PatchOutputs::WriteFactors(Span function) {
  std::vector<StmtId> stmts;
  if (!program_.tessellation.domain || is_refused_) return stmts;
  const DomainInfo& domain = InfoOf(*program_.tessellation.domain);
  WriteKind(Builtin::kTessFactor, domain.factors, function, stmts);
  WriteKind(Builtin::kInsideFactor, domain.inside_factors, function, stmts);
  return stmts;
}

void PatchOutputs::WriteKind(Builtin builtin, std::uint32_t count, Span function,
                             std::vector<StmtId>& stmts) {
  const bool is_outer = builtin == Builtin::kTessFactor;
  const std::string_view name = is_outer ? "SV_TessFactor" : "SV_InsideTessFactor";
  const std::string_view domain = InfoOf(*program_.tessellation.domain).name;
  std::vector<Factor>& factors = is_outer ? outer_ : inside_;
  std::ranges::stable_sort(factors, {}, &Factor::index);
  const auto is_left = [&](const Factor& factor) { return factor.index >= count; };
  const auto left = std::ranges::find_if(factors, is_left);
  if (left != factors.end())
    diagnostics_.Report(left->span, diag::TessFactorUnused, left->index, name, domain, count);
  factors.erase(left, factors.end());
  if (factors.size() < count) {
    const Span span = factors.empty() ? function : factors.front().span;
    diagnostics_.Report(span, diag::TessFactorsMissing, factors.size(), name, domain, count);
    return;
  }
  if (count == 0) return;
  Carrier leaf;
  leaf.type = program_.types.Array(program_.types.Make(Scalar::kFloat), count);
  leaf.name = is_outer ? "tess_factors" : "inside_tess_factors";
  leaf.cursor.semantic.name = name;
  leaf.span = factors.front().span;
  const VarId array = vars_.AddOutput(leaf, leaf.type, builtin);
  program_.vars[array].name = leaf.name;
  const auto most = program_.tessellation.max_factor;
  for (std::uint32_t i = 0; i < count; ++i) {
    ExprId value = factors[i].value;
    if (most)
      value = builder_.IntrinsicOf(CommonIntrinsic::kMin, builder_.TypeOf(value),
                                   {value, builder_.Float(*most)});
    stmts.push_back(builder_.Eval(builder_.AssignTo(builder_.At(builder_.Ref(array), i), value)));
  }
}

}  // namespace clipc::signature
