// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/outputs.h"

#include <algorithm>

#include <fmt/format.h>

#include "backend-glsl/requirements.h"
#include "backend-glsl/text.h"
#include "backend-glsl/writer/interface.h"
#include "backend-glsl/writer/output_groups.h"
#include "backend-glsl/writer/types.h"
#include "ir/access.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// Whether each control point has its own value of the output.
bool IsOfPoint(const Program& program, const IoVar& output) {
  return InfoOf(program.stage).makes_patches && !output.is_of_patch;
}

void WriteVarying(WriterContext& context, const IoVar& output, const GlslInfo::Variable& info,
                  std::string& text) {
  const auto& reader = output.reader;
  // It is declared with its block, or with the first of its elements.
  if (reader && (reader->group || reader->element > 0)) return;
  const Shape shape = context.ShapeAt(output.var);
  if (context.program.emission.streams.size() > 1)
    Append(text, "layout(stream = ", StreamOf(context.program, output.var), ") ");
  Append(text, LocationText{info.location}, PreciseText(context, context[output.var].precise),
         output.is_of_patch ? "patch "
                            : InterpolationText(context, {shape.scalar, output.interpolation,
                                                          output.centroid, output.sample}),
         context.Has(Feature::kInAndOut) ? "out " : "varying ", PrecisionText(context, output));
  std::string declaration;
  AppendVarying(context, declaration, output, shape, info.name);
  // [outputcontrolpoints] says how many control points there are.
  text += IsOfPoint(context.program, output) ? AtVertex(declaration, "") : declaration;
  Append(text, ";", SemanticComment{output, info.name});
}

// Declares an output to a render target; GLSL without `out` has gl_FragData in its place.
void WriteTarget(WriterContext& context, const IoVar& output, const GlslInfo::Variable& info,
                 std::string& text) {
  if (!context.Has(Feature::kInAndOut)) {
    if (output.location > 0) context.Require(Feature::kSeveralTargets);
    return;
  }
  if (output.blend_index > 0) {
    context.Require(Feature::kBlendIndices);
    Append(text, "layout(location = ", output.location, ", index = ", output.blend_index, ") ");
  } else {
    AppendPart(text, LocationText{info.location});
  }
  Append(text, PreciseText(context, context[output.var].precise), "out ",
         PrecisionText(context, output));
  AppendDeclaration(context, text, context.ShapeAt(output.var), info.name);
  Append(text, ";", SemanticComment{output, info.name});
}

// Declares clip and cull distances anew, since they have no size of their own: as members of
// gl_PerVertex where the interface between separate stages is built from it, otherwise as arrays
// alone.
void WritePerVertex(WriterContext& context, const GlslInfo& info, std::string& text) {
  if (!InfoOf(context.program.stage).has_stage_after) return;  // its outputs are no vertex's
  const bool is_vulkan = context.target.IsVulkan(), is_es = context.target.IsEs();
  const bool has_block = is_vulkan || (!is_es && context.target.version() >= 410);
  const bool in_block = has_block && (is_vulkan || context.options.separable);
  // Elsewhere the sizes of the arrays of control points follow from the indices.
  const bool is_of_points = InfoOf(context.program.stage).makes_patches;
  if (is_of_points && !in_block) return;
  std::string comments, arrays;
  const auto declare = [&](Builtin builtin, const char* what, std::uint32_t mask) {
    const auto output = std::ranges::find(context.program.outputs, builtin, &IoVar::builtin);
    if (output == context.program.outputs.end()) return;
    comments += fmt::format("// {} distances written: 0x{:x}\n", what, mask);
    Append(arrays, in_block ? "    " : "", PreciseText(context, context[output->var].precise),
           in_block ? ""
           : is_es  ? "out highp "
                    : "out ",
           "float ", BuiltinOutput(builtin, context.target), Dimensions(context, output->var),
           ";\n");
  };
  declare(Builtin::kClipDistance, "clip", info.clip_distance_mask);
  declare(Builtin::kCullDistance, "cull", info.cull_distance_mask);
  const bool is_asked = in_block && (context.options.separable || !arrays.empty());
  Append(text, comments,
         is_asked ? "out gl_PerVertex {\n    vec4 gl_Position;\n    float gl_PointSize;\n" : "",
         arrays, is_asked ? is_of_points ? "} gl_out[];\n" : "};\n" : "");
}

// Writes the qualifiers of built-in outputs that are not declared anew.
void QualifyBuiltins(WriterContext& context, std::string& text) {
  for (const IoVar& output : context.program.outputs) {
    const bool is_less = output.builtin == Builtin::kDepthLessEqual;
    if ((is_less || output.builtin == Builtin::kDepthGreaterEqual) &&
        context.Has(Feature::kConservativeDepth)) {
      context.Require(Feature::kConservativeDepth);
      Append(text, "layout(depth_", is_less ? "less" : "greater", ") out float gl_FragDepth;\n");
    }
    if (IsOfPoint(context.program, output)) continue;
    const bool is_position = output.builtin == Builtin::kPosition;
    if (!is_position && output.builtin != Builtin::kPointSize && !IsDepth(output.builtin)) continue;
    const std::string_view name = BuiltinOutput(output.builtin, context.target);
    const std::string_view precise = PreciseText(context, context[output.var].precise);
    if (!precise.empty()) Append(text, precise, name, ";\n");
    if (is_position && context.options.invariant) Append(text, "invariant ", name, ";\n");
  }
}

}  // namespace

std::uint32_t WrittenElements(const WriterContext& context, VarId array) {
  const std::uint32_t count = context.TypeOf(array).count;
  const std::uint32_t all = count >= 32 ? ~0u : (1u << count) - 1;
  std::uint32_t mask = 0;
  const FunctionId writer = OutputFunction(context.program);
  ForEachStmt(context.program, context[writer].body, [&](StmtId stmt) {
    const Assign* assign = AsAssignment(context.program, stmt);
    if (!assign || RootOf(context.program, assign->target) != array) return;
    const auto* index = context.As<Index>(assign->target);
    const auto* element = index ? context.As<Literal>(index->index) : nullptr;
    mask |= element ? 1u << (UintOf(element->bits) & 31) : all;
  });
  return mask & all;
}

std::string_view BuiltinOutput(Builtin builtin, const Target& target) {
  switch (builtin) {
    case Builtin::kPosition: return "gl_Position";
    case Builtin::kClipVertex: return "gl_ClipVertex";
    case Builtin::kClipDistance: return "gl_ClipDistance";
    case Builtin::kCullDistance: return "gl_CullDistance";
    case Builtin::kPointSize: return "gl_PointSize";
    case Builtin::kLayer: return "gl_Layer";
    case Builtin::kViewportIndex: return "gl_ViewportIndex";
    case Builtin::kPrimitiveIdOutput: return "gl_PrimitiveID";
    case Builtin::kTessFactor: return "gl_TessLevelOuter";
    case Builtin::kInsideFactor: return "gl_TessLevelInner";
    case Builtin::kShadingRate: return "gl_PrimitiveShadingRateEXT";
    case Builtin::kDepth:
    case Builtin::kDepthGreaterEqual:
    case Builtin::kDepthLessEqual:
      return target.HasInCore(Feature::kDepthOutput) ? "gl_FragDepth" : "gl_FragDepthEXT";
    case Builtin::kCoverage: return "gl_SampleMask[0]";
    case Builtin::kStencilRef: return "gl_FragStencilRefARB";
    default: return "";
  }
}

bool IsIntOutput(Builtin builtin) {
  switch (builtin) {
    case Builtin::kShadingRate:
    case Builtin::kLayer:
    case Builtin::kViewportIndex:
    case Builtin::kPrimitiveIdOutput:
    case Builtin::kCoverage:
    case Builtin::kStencilRef: return true;
    default: return false;
  }
}

void NameAtPoint(WriterContext& context, const GlslInfo& info) {
  if (!InfoOf(context.program.stage).makes_patches) return;
  for (std::size_t i = 0; i < info.outputs.size(); ++i) {
    const IoVar& output = context.program.outputs[i];
    context.names.outputs.push_back(info.outputs[i].name);
    if (!output.is_of_patch)
      context.names.vars[output.var.index] = AtPoint(context, output.var, "gl_InvocationID");
  }
}

std::string AtPoint(const WriterContext& context, VarId output, std::string_view point) {
  const auto& outputs = context.program.outputs;
  const auto found = std::ranges::find(outputs, output, &IoVar::var);
  const std::string& name =
      context.names.outputs[static_cast<std::size_t>(found - outputs.begin())];
  if (found->builtin != Builtin::kNone) return Concat("gl_out[", point, "].", name);
  return AtVertex(name, point);
}

std::string WriteOutputs(WriterContext& context, const GlslInfo& info) {
  std::string text;
  text.reserve(512);
  text += GroupsText(context);
  const bool has_stage_after = InfoOf(context.program.stage).has_stage_after;
  for (std::size_t i = 0; i < info.outputs.size(); ++i) {
    const IoVar& output = context.program.outputs[i];
    if (const Requirement* requirement =
            RequirementOf(output.builtin, InfoOf(context.program.stage)))
      context.Require(requirement->feature);
    if (output.builtin != Builtin::kNone) continue;
    if (has_stage_after)
      WriteVarying(context, output, info.outputs[i], text);
    else
      WriteTarget(context, output, info.outputs[i], text);
  }
  WritePerVertex(context, info, text);
  QualifyBuiltins(context, text);
  return text;
}

}  // namespace clipc::glsl
