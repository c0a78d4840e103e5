// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/stage_writer.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "backend-glsl/writer/bindings.h"
#include "backend-glsl/writer/blocks.h"
#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/interface.h"
#include "backend-glsl/writer/lay_blocks.h"
#include "backend-glsl/writer/naming.h"
#include "backend-glsl/writer/objects.h"
#include "backend-glsl/writer/outputs.h"
#include "backend-glsl/writer/stmt.h"
#include "backend-glsl/writer/types.h"

namespace clipc::glsl {

using namespace ir;

namespace {

struct Globals {
  std::string text;  // the declarations
  std::vector<LateGlobal> late;
};

Globals WriteGlobals(Code& code) {
  Globals globals;
  for (const VarId id : code.reached.globals) {
    const Var& var = code[id];
    if (var.storage == Storage::kShared) {
      Append(globals.text, "shared ", Declaration(code, var.type, code.NameOf(id)), ";\n");
      continue;
    }
    // HLSL's static variables start as zero.
    std::string value = var.init ? Argument(code, var.init) : ZeroText(code, var.type);
    const bool is_specialized = var.constant_id && code.target.IsVulkan();
    const bool is_const = is_specialized || code.constants.Has(id);
    const bool is_late = !code.Has(Feature::kGlobalInitializers) && !code.constants.HasValueOf(id);
    if (is_specialized) {
      globals.text += LayoutText({Concat("constant_id = ", std::to_string(*var.constant_id))});
    }
    Append(globals.text, is_const ? "const " : "", PrecisionText(code, var.type),
           Declaration(code, var.type, code.NameOf(id)), is_late ? "" : " = ", is_late ? "" : value,
           ";\n");
    // glslang 12 takes `precise vec4 a;` for a variable of `main`.
    const std::string_view precise = PreciseText(code, var.precise && !is_const);
    if (!precise.empty()) Append(globals.text, precise, code.NameOf(id), ";\n");
    if (is_late) globals.late.push_back({code.NameOf(id), std::move(value)});
  }
  return globals;
}

std::string_view InputWord(Primitive primitive) {
  switch (primitive) {
    case Primitive::kPoint: return "points";
    case Primitive::kLine: return "lines";
    case Primitive::kTriangle: return "triangles";
    case Primitive::kLineAdjacent: return "lines_adjacency";
    default: return "triangles_adjacency";
  }
}

std::string_view OutputWord(Primitive primitive) {
  return primitive == Primitive::kPoint  ? "points"
         : primitive == Primitive::kLine ? "line_strip"
                                         : "triangle_strip";
}

// Direct3D's v grows downwards in the domain and OpenGL's upwards, so that a triangle that is
// clockwise in the one is counterclockwise in the other; Vulkan's domain is Direct3D's
// (VK_TESSELLATION_DOMAIN_ORIGIN_UPPER_LEFT). The points of a triangle's corners keep their order.
std::string TessellatorText(const Tessellation& patch, const Target& target) {
  constexpr std::string_view kShapes[] = {"triangles", "quads", "isolines"};
  constexpr std::string_view kSpacings[] = {"equal_spacing", "equal_spacing",
                                            "fractional_even_spacing", "fractional_odd_spacing"};
  std::string text(kShapes[static_cast<std::size_t>(*patch.domain)]);
  text += Concat(
      ", ",
      kSpacings[static_cast<std::size_t>(patch.partitioning.value_or(Partitioning::kInteger))]);
  const OutputTopology topology = patch.topology.value_or(OutputTopology::kTriangleCw);
  const bool is_clockwise = topology == OutputTopology::kTriangleCw;
  if (is_clockwise || topology == OutputTopology::kTriangleCcw)
    text += is_clockwise == target.IsVulkan() ? ", cw" : ", ccw";
  if (topology == OutputTopology::kPoint) text += ", point_mode";
  return text;
}

std::string Header(const WriterContext& context) {
  std::string text = context.target.VersionLine() + "\n";
  for (const std::string& extension : context.extensions)
    Append(text, "#extension ", extension, " : require\n");
  for (const std::string& extension : context.enabled)
    Append(text, "#extension ", extension, " : enable\n");
  // Fragment shaders of OpenGL ES have no precision of their own; Direct3D's numbers have 32 bits.
  if (InfoOf(context.program.stage).draws_pixels && context.target.IsEs())
    text += "\nprecision highp float;\nprecision highp int;\n";
  if (InfoOf(context.program.stage).runs_in_groups) {
    const auto& [x, y, z] = context.program.group_size;
    Append(text, "\nlayout(local_size_x = ", x, ", local_size_y = ", y, ", local_size_z = ", z);
    for (std::size_t i = 0; i < context.program.group_size_constants.size(); ++i) {
      const VarId constant = context.program.group_size_constants[i];
      if (constant && context.target.IsVulkan())
        Append(text, ", local_size_", std::string_view("xyz").substr(i, 1),
               "_id = ", *context[constant].constant_id);
    }
    text += ") in;\n";
  }
  if (InfoOf(context.program.stage).emits_vertices) {
    const Emission& emission = context.program.emission;
    Append(text, "\nlayout(", InputWord(emission.input));
    if (emission.instances > 1) Append(text, ", invocations = ", emission.instances);
    Append(text, ") in;\nlayout(", OutputWord(emission.output),
           ", max_vertices = ", emission.max_vertices, ") out;\n");
  }
  if (InfoOf(context.program.stage).reads_patches)
    Append(text, "\nlayout(", TessellatorText(context.program.tessellation, context.target),
           ") in;\n");
  if (InfoOf(context.program.stage).makes_patches)
    Append(text, "\nlayout(vertices = ", context.program.tessellation.output_points, ") out;\n");
  if (context.program.tests_early) text += "\nlayout(early_fragment_tests) in;\n";
  if (context.has_order) {
    const bool is_per_sample = std::ranges::any_of(context.program.inputs, [](const IoVar& input) {
      return input.sample || input.builtin == Builtin::kSampleIndex;
    });
    Append(text, "\nlayout(", is_per_sample ? "sample" : "pixel", "_interlock_ordered) in;\n");
  }
  return text + "\n";
}

}  // namespace

StageWriter::StageWriter(const Program& program, const Target& target, const WriteOptions& options,
                         OtherStages others)
    : packed_(program, target, options.blocks, others), code_(packed_, target, options, others) {
  code_.names = NameEverything(code_);
  code_.names.functions = NameFunctions(code_);
  code_.texture_uses = FindTextureUses(code_);
  info_.blocks = LayBlocks(code_);
  info_.objects = LayObjects(code_);
  LayInterface(code_, info_);
  NameAtPoint(code_, info_);
  info_.framebuffer_height = code_.names.framebuffer_height;
}

std::string StageWriter::Finish(CommentOf comment_of) {
  code_.comment_of = std::move(comment_of);
  const std::string blocks = WriteBlocks(code_, info_.blocks);
  std::string objects = WriteObjects(code_, info_.objects);
  std::string inputs = WriteInputs(code_, info_);
  std::string outputs = WriteOutputs(code_, info_);
  if (InfoOf(code_.program.stage).emits_vertices) code_.Require(Feature::kGeometryShaders);
  const StageInfo& stage = InfoOf(code_.program.stage);
  if (stage.makes_patches || stage.reads_patches) code_.Require(Feature::kTessellation);
  // OpenGL ES links stages whose gl_PerVertex has the same members.
  if (std::ranges::any_of(code_.others, &OtherStage::has_distances))
    code_.Require(Feature::kClipDistance);
  if (code_.program.emission.instances > 1) code_.Require(Feature::kEmitters);
  if (code_.program.emission.streams.size() > 1) code_.Require(Feature::kStreams);
  Globals globals = WriteGlobals(code_);
  const std::string functions = WriteFunctions(code_, globals.late);
  for (std::string* part : {&objects, &inputs, &outputs, &globals.text}) {
    if (!part->empty()) *part += "\n";
  }
  return Concat(Header(code_), code_.structs, blocks, objects, inputs, outputs, code_.helpers,
                globals.text, functions);
}

}  // namespace clipc::glsl
