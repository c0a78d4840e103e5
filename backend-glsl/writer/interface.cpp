// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/interface.h"

#include <algorithm>

#include <fmt/format.h>

#include "backend-glsl/requirements.h"
#include "backend-glsl/text.h"
#include "backend-glsl/writer/bindings.h"
#include "backend-glsl/writer/output_groups.h"
#include "backend-glsl/writer/outputs.h"
#include "backend-glsl/writer/types.h"
#include "base/invariant.h"
#include "ir/access.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// Two views, as for a headset: OVR_multiview requires the number in the shader.
constexpr std::uint32_t kViews = 2;

// Whether the shader reads neither attributes nor objects, as that of a full-screen triangle: there
// are no vertices in memory, of which a draw call could leave out the first.
bool HasNoVertices(const WriterContext& context) {
  const auto is_attribute = [&](const IoVar& input) {
    return input.builtin == Builtin::kNone && context.reached.Has(input.var);
  };
  return std::ranges::none_of(context.program.inputs, is_attribute) &&
         std::ranges::none_of(context.program.resources, [&](const Resource& resource) {
           return context.reached.Has(resource.var);
         });
}

// Whether the draw calls' first vertex is a part of gl_VertexID, and nothing subtracts it.
bool KeepsBaseVertex(const WriterContext& context) {
  if (context.target.IsVulkan()) return context.options.base_vertex_is_zero;
  return context.Has(Feature::kBaseVertexDraws) &&
         (context.options.base_vertex_is_zero || !context.Has(Feature::kDrawParameters) ||
          HasNoVertices(context));
}

bool KeepsBaseInstance(const WriterContext& context) {
  return context.target.IsVulkan() && context.options.base_instance_is_zero;
}

// The value of an input that is a built-in variable of GLSL.
std::string BuiltinInput(const WriterContext& context, Builtin builtin) {
  const bool is_vulkan = context.target.IsVulkan();
  const bool is_core = context.target.Of(Feature::kDrawParameters).extension.empty();
  const std::string suffix = is_core ? "" : "ARB";
  switch (builtin) {
    case Builtin::kVertexId:
      if (is_vulkan)
        return KeepsBaseVertex(context) ? "gl_VertexIndex" : "gl_VertexIndex - gl_BaseVertex";
      if (!context.Has(Feature::kBaseVertexDraws) || KeepsBaseVertex(context)) return "gl_VertexID";
      return "gl_VertexID - gl_BaseVertex" + suffix;
    case Builtin::kInstanceId:
      if (KeepsBaseInstance(context)) return "gl_InstanceIndex";
      if (is_vulkan) return "gl_InstanceIndex - gl_BaseInstance";
      return context.target.HasInCore(Feature::kInstanceId) ? "gl_InstanceID" : "gl_InstanceIDARB";
    case Builtin::kBaseVertex: return "gl_BaseVertex" + suffix;
    case Builtin::kBaseInstance: return "gl_BaseInstance" + suffix;
    case Builtin::kDrawIndex: return "gl_DrawID" + suffix;
    case Builtin::kViewId: return is_vulkan ? "gl_ViewIndex" : "gl_ViewID_OVR";
    case Builtin::kVertexIndex: return is_vulkan ? "gl_VertexIndex" : "gl_VertexID";
    case Builtin::kInstanceIndex:
      return is_vulkan ? "gl_InstanceIndex" : "gl_InstanceID + gl_BaseInstance" + suffix;
    case Builtin::kPixelPosition: return "gl_FragCoord";
    case Builtin::kFrontFacing: return "gl_FrontFacing";
    case Builtin::kSampleIndex: return "gl_SampleID";
    case Builtin::kCoverageInput: return "gl_SampleMaskIn[0]";
    case Builtin::kPrimitiveId:
      return InfoOf(context.program.stage).emits_vertices ? "gl_PrimitiveIDIn" : "gl_PrimitiveID";
    case Builtin::kEmitterId:
    case Builtin::kControlPointId: return "gl_InvocationID";
    case Builtin::kDomainLocation: return "gl_TessCoord";
    case Builtin::kTessFactorInput: return "gl_TessLevelOuter";
    case Builtin::kInsideFactorInput: return "gl_TessLevelInner";
    case Builtin::kPositionInput: return "gl_Position";
    case Builtin::kPointSizeInput: return "gl_PointSize";
    case Builtin::kLayerInput: return "gl_Layer";
    case Builtin::kViewportInput: return "gl_ViewportIndex";
    case Builtin::kBarycentrics: return is_vulkan ? "gl_BaryCoordEXT" : "gl_BaryCoordNV";
    case Builtin::kBarycentricsNoPerspective:
      return is_vulkan ? "gl_BaryCoordNoPerspEXT" : "gl_BaryCoordNoPerspNV";
    case Builtin::kFullyCovered: return "gl_FragFullyCoveredNV";
    case Builtin::kSampleCount: return "gl_NumSamples";
    case Builtin::kHelperLane: return "gl_HelperInvocation";
    case Builtin::kLaneCount: return "gl_SubgroupSize";
    case Builtin::kLaneIndex: return "gl_SubgroupInvocationID";
    case Builtin::kShadingRateInput: return "gl_ShadingRateEXT";
    case Builtin::kThreadId: return "gl_GlobalInvocationID";
    case Builtin::kGroupId: return "gl_WorkGroupID";
    case Builtin::kGroupThreadId: return "gl_LocalInvocationID";
    case Builtin::kGroupIndex: return "gl_LocalInvocationIndex";
    case Builtin::kClipDistanceInput: return "gl_ClipDistance";
    case Builtin::kCullDistanceInput: return "gl_CullDistance";
    default: break;
  }
  CLIPC_CHECK(!"a built-in input");
  return "";
}

// Whether GLSL has the input as a uint too. Others that are integers in HLSL are ints.
bool IsUintInput(Builtin builtin) {
  constexpr Builtin kUints[] = {Builtin::kLaneCount, Builtin::kLaneIndex,     Builtin::kThreadId,
                                Builtin::kGroupId,   Builtin::kGroupThreadId, Builtin::kGroupIndex};
  return std::ranges::find(kUints, builtin) != std::end(kUints);
}

bool IsDistanceInput(const IoVar& input) {
  return input.builtin == Builtin::kClipDistanceInput ||
         input.builtin == Builtin::kCullDistanceInput;
}

// Names the extensions that a built-in input needs, and declares what must be declared.
void WriteBuiltin(WriterContext& context, const IoVar& input, const GlslInfo::Variable& info,
                  std::string& text) {
  if (const Requirement* requirement = RequirementOf(input.builtin, InfoOf(context.program.stage)))
    context.Require(requirement->feature);
  const bool is_vulkan = context.target.IsVulkan();
  if (input.builtin == Builtin::kVertexId && !is_vulkan && context.Has(Feature::kBaseVertexDraws) &&
      !info.needs_base_vertex_zero)
    context.Require(Feature::kDrawParameters);
  const std::string& height = context.names.framebuffer_height;
  if (input.builtin == Builtin::kPixelPosition && !height.empty()) {
    Append(text, context.target.IsEs() ? "uniform highp float " : "uniform float ", height,
           ";  // of the framebuffer, in pixels\n");
  } else if (input.builtin == Builtin::kPixelPosition && !context.target.HasUpperLeftOrigin() &&
             (ComponentsRead(context.program)[input.var.index] & 0b10) != 0) {
    context.Require(Feature::kUpperLeftOrigin);
    context.has_upper_left_origin = true;
    text += "layout(origin_upper_left) in vec4 gl_FragCoord;\n";
  }
  if (IsDistanceInput(input) && !InfoOf(context.program.stage).reads_vertices) {
    Append(text, context.target.IsEs() ? "in highp float " : "in float ",
           BuiltinInput(context, input.builtin), Dimensions(context, input.var), ";\n");
  }
  const bool has_stage_before = InfoOf(context.program.stage).has_stage_before;
  if (input.builtin == Builtin::kViewId && !is_vulkan && !has_stage_before) {
    Append(text, "layout(num_views = ", kViews, ") in;", SemanticComment{input, ""});
  }
}

// Declares anew the built-in inputs of each vertex, as the stage before does its outputs: where
// stages are separate, and for Vulkan where the shader reads distances. Elsewhere the sizes of
// these follow from the indices.
void WriteVertices(const WriterContext& context, std::string& text) {
  const bool is_vulkan = context.target.IsVulkan();
  const bool is_separate =
      context.options.separable && !context.target.IsEs() && context.target.version() >= 410;
  std::string arrays;
  bool is_any = false;
  for (const IoVar& input : context.program.inputs) {
    if (!context.reached.Has(input.var)) continue;
    is_any |= input.builtin == Builtin::kPositionInput || input.builtin == Builtin::kPointSizeInput;
    if (IsDistanceInput(input))
      Append(arrays, "    float ", BuiltinInput(context, input.builtin),
             Dimensions(context, input.var), ";\n");
  }
  if ((is_separate && is_any) || ((is_vulkan || is_separate) && !arrays.empty()))
    Append(text, "in gl_PerVertex {\n    vec4 gl_Position;\n    float gl_PointSize;\n", arrays,
           InfoOf(context.program.stage).emits_vertices ? "} gl_in[];\n"
                                                        : "} gl_in[gl_MaxPatchVertices];\n");
}

// Whether the input is an integer in HLSL and a float attribute here. Attributes are floats in GLSL
// 1.20; whole numbers up to 2^24 come through exactly.
bool IsIntegerAsFloat(const WriterContext& context, const IoVar& input) {
  return !context.Has(Feature::kInAndOut) && !context.ShapeAt(input.var).IsFloating() &&
         !InfoOf(context.program.stage).has_stage_before;
}

// Whether the shader reads the input, or another row of the matrix that the input begins.
bool IsDeclared(const WriterContext& context, const IoVar& input) {
  if (!input.reader || input.reader->IsWhole()) return context.reached.Has(input.var);
  return input.reader->element == 0 &&
         std::ranges::any_of(context.program.inputs, [&](const IoVar& other) {
           return other.reader && other.path == input.path && context.reached.Has(other.var);
         });
}

// Whether the shader reads the input at the primitive's vertices, so that it is an array of them.
bool IsPerVertex(const WriterContext& context, VarId input) {
  return std::ranges::any_of(context.reached.asked, [&](ExprId expr) {
    const auto* call = As<IntrinsicCall>(context.program, expr);
    return call && call->op == CommonIntrinsic::kAttributeAtVertex &&
           RootOf(context.program, context.program.expr_lists[call->arguments][0]) == input;
  });
}

// Declares an input that is an output of the stage before, in the same words.
void WriteVaryingInput(WriterContext& context, const IoVar& input, const GlslInfo::Variable& info,
                       std::string& text) {
  if (!IsDeclared(context, input)) return;
  const Shape shape = context.ShapeAt(input.var);
  AppendPart(text, LocationText{info.location});
  if (IsPerVertex(context, input.var)) {
    context.Require(Feature::kBarycentrics);
    std::string declaration;
    AppendVarying(context, declaration, input, shape, info.name);
    Append(text, context.target.IsVulkan() ? "pervertexEXT" : "pervertexNV", " in ",
           AtVertex(declaration, "3"));
  } else {
    Append(text,
           input.is_of_patch ? "patch "
                             : InterpolationText(context, {shape.scalar, input.interpolation,
                                                           input.centroid, input.sample}),
           context.Has(Feature::kInAndOut) ? "in " : "varying ", PrecisionText(context, input));
    std::string declaration;
    AppendVarying(context, declaration, input, shape, info.name);
    // The primitive says how many vertices there are, and for a patch the draw call.
    const bool is_of_vertices = InfoOf(context.program.stage).reads_vertices && !input.is_of_patch;
    text += is_of_vertices ? AtVertex(declaration, "") : declaration;
  }
  Append(text, ";", SemanticComment{input, info.name});
}

void WriteInput(WriterContext& context, const IoVar& input, const GlslInfo::Variable& info,
                std::string& text) {
  if (input.builtin != Builtin::kNone) {
    if (info.is_used) WriteBuiltin(context, input, info, text);
    return;
  }
  if (InfoOf(context.program.stage).has_stage_before)
    return WriteVaryingInput(context, input, info, text);
  if (!info.is_used) return;
  const Shape shape = context.ShapeAt(input.var);
  Append(text, LocationText{info.location}, context.Has(Feature::kInAndOut) ? "in " : "attribute ",
         PrecisionText(context, input));
  AppendDeclaration(context, text, info.integer_as_float ? shape.With(Scalar::kFloat) : shape,
                    info.name);
  Append(text, ";", SemanticComment{input, info.name});
}

GlslInfo::Variable LayInput(const WriterContext& context, const IoVar& input,
                            const std::string& attribute) {
  GlslInfo::Variable info;
  info.is_used = context.reached.Has(input.var);
  if (input.builtin != Builtin::kNone) {
    if (!info.is_used) return info;
    info.needs_base_vertex_zero = input.builtin == Builtin::kVertexId && KeepsBaseVertex(context);
    info.needs_base_instance_zero =
        input.builtin == Builtin::kInstanceId && KeepsBaseInstance(context);
    info.name = context.NameOf(input.var);
    return info;
  }
  const bool is_attribute = !InfoOf(context.program.stage).has_stage_before;
  info.name = attribute;
  if (context.Has(is_attribute ? Feature::kInputLocations : Feature::kOutputLocations))
    info.location = input.location;
  info.integer_as_float = info.is_used && IsIntegerAsFloat(context, input);
  return info;
}

// Lays an output that is not built in at its location, or at `location` if that is higher. Returns
// the location after it.
std::uint32_t LayVarying(const WriterContext& context, const IoVar& output,
                         GlslInfo::Variable& info, std::uint32_t location) {
  location = std::max(location, output.location);
  const auto& reader = output.reader;
  if (context.Has(Feature::kOutputLocations) && (!reader || reader->has_location))
    info.location = location;
  if (reader && reader->group) info.name = reader->name;
  const bool is_part = reader && (reader->group || reader->element > 0);
  return location + (is_part ? 1 : LocationCount(context.TypeOf(output.var)));
}

}  // namespace

std::string AtVertex(std::string_view name, std::string_view vertex) {
  const std::size_t end = std::min(name.find('['), name.size());
  return Concat(name.substr(0, end), "[", vertex, "]", name.substr(end));
}

void AppendVarying(WriterContext& context, std::string& text, const IoVar& io, Shape shape,
                   std::string_view name) {
  if (!io.reader || io.reader->IsWhole()) return AppendDeclaration(context, text, shape, name);
  if (io.reader->columns > 1) {
    shape.kind = Shape::kMatrix;
    shape.rows = static_cast<std::uint8_t>(io.reader->columns);
  }
  AppendDeclaration(context, text, shape, name.substr(0, name.find('[')));
  for (const std::uint32_t dimension : io.reader->dimensions) Append(text, "[", dimension, "]");
}

std::string InputText(const WriterContext& context, const IoVar& input,
                      const std::string& attribute) {
  const bool is_array = context.TypeOf(input.var).kind == TypeKind::kArray;
  if (is_array) return BuiltinInput(context, input.builtin);
  const Shape shape = context.ShapeAt(input.var);
  const auto converted = [&](const std::string& value) {
    return Concat(legalize::NameOf(shape, !context.needs.signed_integers), "(", value, ")");
  };
  if (input.builtin == Builtin::kUntranslated) return "";
  if (input.builtin != Builtin::kNone && (!IsInteger(shape.scalar) || IsUintInput(input.builtin)))
    return BuiltinInput(context, input.builtin);
  if (input.builtin != Builtin::kNone) return converted(BuiltinInput(context, input.builtin));
  if (IsPerVertex(context, input.var)) return AtVertex(attribute, "0");
  return IsIntegerAsFloat(context, input) ? converted(attribute) : attribute;
}

std::string AtVertex(const WriterContext& context, VarId input, std::string_view vertex) {
  const auto& inputs = context.program.inputs;
  const auto found = std::ranges::find(inputs, input, &IoVar::var);
  const auto number = static_cast<std::size_t>(found - inputs.begin());
  if (inputs[number].builtin != Builtin::kNone)
    return Concat("gl_in[", vertex, "].", BuiltinInput(context, inputs[number].builtin));
  return AtVertex(context.names.attributes[number], vertex);
}

bool IsPixelPosition(const WriterContext& context, VarId var) {
  return InfoOf(context.program.stage).draws_pixels && context[var].storage == Storage::kInput &&
         std::ranges::any_of(context.program.inputs, [&](const IoVar& input) {
           return input.var == var && input.builtin == Builtin::kPixelPosition;
         });
}

void LayInterface(const WriterContext& context, GlslInfo& info) {
  const Program& program = context.program;
  info.inputs.reserve(program.inputs.size());
  for (std::size_t i = 0; i < program.inputs.size(); ++i)
    info.inputs.push_back(LayInput(context, program.inputs[i], context.names.attributes[i]));
  info.outputs.reserve(program.outputs.size());
  std::uint32_t location = 0;
  for (const IoVar& output : program.outputs) {
    GlslInfo::Variable& laid = info.outputs.emplace_back();
    laid.name = context.NameOf(output.var);
    if (output.builtin == Builtin::kClipDistance)
      info.clip_distance_mask = WrittenElements(context, output.var);
    if (output.builtin == Builtin::kCullDistance)
      info.cull_distance_mask = WrittenElements(context, output.var);
    if (output.builtin != Builtin::kNone) continue;
    if (InfoOf(program.stage).has_stage_after)
      location = LayVarying(context, output, laid, location);
    else if (context.Has(Feature::kInAndOut) && context.Has(Feature::kTargetLocations))
      laid.location = output.location;
  }
}

std::string WriteInputs(WriterContext& context, const GlslInfo& info) {
  std::string text;
  text.reserve(512);
  for (std::size_t i = 0; i < info.inputs.size(); ++i)
    WriteInput(context, context.program.inputs[i], info.inputs[i], text);
  if (InfoOf(context.program.stage).reads_vertices) WriteVertices(context, text);
  return text;
}

}  // namespace clipc::glsl
