// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Inputs, outputs and built-in variables.
#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "backend-glsl/needs.h"
#include "backend-glsl/writer.h"
#include "base/invariant.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

std::string SemanticOf(const IoVar& io) { return io.semantic + std::to_string(io.index); }

// A headset's: OVR_multiview wants the number in the shader.
constexpr int kViews = 2;

bool IsIntegral(const Shape& shape) { return !shape.IsFloating(); }

}  // namespace

void Writer::Inputs() {
  info_.inputs.reserve(program_.inputs.size());
  for (const IoVar& input : program_.inputs) {
    GlslInfo::Variable& info = info_.inputs.emplace_back();
    info.is_used = reached_.Has(input.var);
    std::string& name = var_names_[input.var.index];
    if (input.builtin != Builtin::kNone) {
      name = info.is_used ? InputText(input, info) : "";
      info.name = name;
      continue;
    }
    info.name = name;
    if (target_.Has(Feature::kInputLocations)) info.location = input.location;
    if (!info.is_used) continue;
    Shape shape = ShapeOf(program_.types[program_.vars[input.var].type]);
    std::string line;
    if (target_.Has(Feature::kInputLocations)) {
      line = "layout(location = " + std::to_string(input.location) + ") ";
    }
    line += target_.Has(Feature::kInAndOut) ? "in " : "attribute ";
    if (!target_.Has(Feature::kInAndOut) && IsIntegral(shape)) {
      // Attributes are floats in GLSL 1.20; whole numbers up to 2^24 come through exactly.
      info.integer_as_float = true;
      const std::string as_integer = TypeName(shape) + "(" + name + ")";
      shape = shape.With(Scalar::kFloat);
      inputs_ += line + Declaration(shape, name) + ";  // " + SemanticOf(input) + "\n";
      name = as_integer;
      continue;
    }
    inputs_ += line + Declaration(shape, name) + ";  // " + SemanticOf(input) + "\n";
  }
}

// The value of an input that is a built-in variable of GLSL.
std::string Writer::InputText(const IoVar& input, GlslInfo::Variable& info) {
  const std::string type = TypeName(ShapeOf(program_.types[program_.vars[input.var].type]));
  Require(NeedOf(input.builtin)->feature);
  const bool is_core = target_.Of(Feature::kDrawParameters).extension.empty();
  const std::string suffix = is_core ? "" : "ARB";
  const auto draw_parameter = [&](std::string_view name) {
    return type + "(" + std::string(name) + suffix + ")";
  };
  switch (input.builtin) {
    case Builtin::kVertexId: {
      if (target_.IsVulkan()) return type + "(gl_VertexIndex - gl_BaseVertex)";
      if (!target_.Has(Feature::kBaseVertexDraws)) return type + "(gl_VertexID)";
      if (!target_.Has(Feature::kDrawParameters)) {
        info.needs_base_vertex_zero = true;
        return type + "(gl_VertexID)";
      }
      Require(Feature::kDrawParameters);
      return type + "(gl_VertexID - gl_BaseVertex" + suffix + ")";
    }
    case Builtin::kInstanceId:
      if (target_.IsVulkan()) return type + "(gl_InstanceIndex - gl_BaseInstance)";
      return type + (target_.Of(Feature::kInstanceId).extension.empty() ? "(gl_InstanceID)"
                                                                        : "(gl_InstanceIDARB)");
    case Builtin::kBaseVertex: return draw_parameter("gl_BaseVertex");
    case Builtin::kBaseInstance: return draw_parameter("gl_BaseInstance");
    case Builtin::kDrawIndex: return draw_parameter("gl_DrawID");
    case Builtin::kViewId:
      if (target_.IsVulkan()) return type + "(gl_ViewIndex)";
      inputs_ +=
          "layout(num_views = " + std::to_string(kViews) + ") in;  // " + SemanticOf(input) + "\n";
      return type + "(gl_ViewID_OVR)";
    case Builtin::kVertexIndex:
      return type + (target_.IsVulkan() ? "(gl_VertexIndex)" : "(gl_VertexID)");
    case Builtin::kInstanceIndex:
      if (target_.IsVulkan()) return type + "(gl_InstanceIndex)";
      return type + "(gl_InstanceID + gl_BaseInstance" + suffix + ")";
    default: break;
  }
  CLIPC_CHECK(!"a built-in input");
  return "";
}

std::string Writer::OutputName(const IoVar& output) const {
  switch (output.builtin) {
    case Builtin::kPosition: return "gl_Position";
    case Builtin::kClipVertex: return "gl_ClipVertex";
    case Builtin::kClipDistance: return "gl_ClipDistance";
    case Builtin::kCullDistance: return "gl_CullDistance";
    case Builtin::kPointSize: return "gl_PointSize";
    case Builtin::kLayer: return "gl_Layer";
    case Builtin::kViewportIndex: return "gl_ViewportIndex";
    case Builtin::kShadingRate: return "gl_PrimitiveShadingRateEXT";
    default: return var_names_[output.var.index];
  }
}

void Writer::Outputs() {
  info_.outputs.reserve(program_.outputs.size());
  std::uint32_t location = 0;
  for (const IoVar& output : program_.outputs) {
    GlslInfo::Variable& info = info_.outputs.emplace_back();
    info.name = OutputName(output);
    var_names_[output.var.index] = info.name;
    if (output.builtin == Builtin::kClipDistance)
      info_.clip_distance_mask = WrittenElements(output.var);
    if (output.builtin == Builtin::kCullDistance)
      info_.cull_distance_mask = WrittenElements(output.var);
    if (const Need* need = NeedOf(output.builtin)) Require(need->feature);
    if (output.builtin == Builtin::kShadingRate || output.builtin == Builtin::kLayer ||
        output.builtin == Builtin::kViewportIndex) {
      integer_outputs_.push_back(output.var);
    }
    if (output.builtin != Builtin::kNone) continue;
    const Shape shape = ShapeOf(program_.types[program_.vars[output.var].type]);
    location = std::max(location, output.location);
    std::string line;
    if (target_.Has(Feature::kOutputLocations)) {
      info.location = location;
      line = "layout(location = " + std::to_string(location) + ") ";
    }
    location += shape.scalar == Scalar::kDouble && shape.size > 2 ? 2 : 1;

    const bool is_flat = IsIntegral(shape) || shape.scalar == Scalar::kDouble ||
                         output.interpolation == Interpolation::kNoInterpolation;
    if (is_flat && target_.Has(Feature::kInAndOut)) line += "flat ";
    if (!is_flat && output.interpolation == Interpolation::kNoPerspective) line += "noperspective ";
    if (output.centroid) line += "centroid ";
    if (output.sample) {
      Require(Feature::kPerSample);
      line += "sample ";
    }
    line += target_.Has(Feature::kInAndOut) ? "out " : "varying ";
    Append(outputs_, line, Declaration(shape, info.name), ";  // ", SemanticOf(output), "\n");
  }
  PerVertex();
}

// Clip and cull distances have no size of their own and are declared anew: as a member of
// gl_PerVertex where the interface between separate stages is built from it, else as the array
// alone.
void Writer::PerVertex() {
  const auto find = [&](Builtin builtin) -> const IoVar* {
    const auto found = std::ranges::find(program_.outputs, builtin, &IoVar::builtin);
    return found == program_.outputs.end() ? nullptr : &*found;
  };
  const auto array = [&](const IoVar* output, const char* name) {
    const std::uint32_t count = program_.types[program_.vars[output->var].type].count;
    return "float " + std::string(name) + "[" + std::to_string(count) + "];";
  };
  const IoVar* clip = find(Builtin::kClipDistance);
  const IoVar* cull = find(Builtin::kCullDistance);
  const auto comment = [&](const char* what, std::uint32_t mask) {
    outputs_ +=
        "// " + std::string(what) + " distances written: 0x" + fmt::format("{:x}", mask) + "\n";
  };
  if (clip) comment("clip", info_.clip_distance_mask);
  if (cull) comment("cull", info_.cull_distance_mask);
  const bool has_block = target_.IsVulkan() || (!target_.IsEs() && target_.version() >= 410);
  const bool is_asked = options_.separable || (target_.IsVulkan() && (clip || cull));
  if (has_block && is_asked) {
    outputs_ += "out gl_PerVertex {\n    vec4 gl_Position;\n    float gl_PointSize;\n";
    if (clip) outputs_ += "    " + array(clip, "gl_ClipDistance") + "\n";
    if (cull) outputs_ += "    " + array(cull, "gl_CullDistance") + "\n";
    outputs_ += "};\n";
  } else {
    const std::string lead = target_.IsEs() ? "out highp " : "out ";
    if (clip) outputs_ += lead + array(clip, "gl_ClipDistance") + "\n";
    if (cull) outputs_ += lead + array(cull, "gl_CullDistance") + "\n";
  }
}

// Which elements of an output array `main` assigns; all when it assigns the whole, or an element
// that is not constant.
std::uint32_t Writer::WrittenElements(VarId array) const {
  const std::uint32_t count = program_.types[program_.vars[array].type].count;
  const std::uint32_t all = count >= 32 ? ~0u : (1u << count) - 1;
  std::uint32_t mask = 0, references = 0, elements = 0;
  ForEachExpr(program_, program_.functions[program_.main].body, [&](ExprId id) {
    const auto& node = program_.exprs[id].node;
    const auto* ref = std::get_if<VarRef>(&node);
    if (ref && ref->var == array) ++references;
    const auto* assign = std::get_if<Assign>(&node);
    const auto* index = assign ? std::get_if<Index>(&program_.exprs[assign->target].node) : nullptr;
    if (!index) return;
    const auto* base = std::get_if<VarRef>(&program_.exprs[index->base].node);
    const auto* element = std::get_if<Literal>(&program_.exprs[index->index].node);
    if (!base || base->var != array || !element) return;
    ++elements;
    mask |= 1u << (UintOf(element->bits) & 31);
  });
  return references == elements ? mask & all : all;
}

}  // namespace clipc::glsl
