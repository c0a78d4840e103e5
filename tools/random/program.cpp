// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/program.h"

#include <algorithm>
#include <optional>

#include "tools/random/emitter.h"
#include "tools/random/group.h"
#include "tools/random/interface.h"
#include "tools/random/layout.h"
#include "tools/random/loops.h"
#include "tools/random/patch.h"

namespace clipc::random {
namespace {

// At most `most` texts of one kind, one after another.
template <typename Make>
std::string Some(Context& context, int most, Make&& make) {
  std::string text;
  Repeat(context.choices, most, 65, [&](int) { text += make(context); });
  return text;
}

// The entry of a pixel shader. Neighbours are asked before anything can end some pixels alone.
std::string MakePixelEntry(Context& context, const Program& program) {
  const ScopeOf scope(context);
  const EntryInputs inputs = MakeInputs(context, false);
  std::string body = inputs.statements + MakeNeighbourStatements(context, 6);
  body += MakeStatements(context, 10, 3);
  const EntryOutputs outputs = MakeOutputs(context, program.is_soft);
  return inputs.structs + "struct Outputs {\n" + outputs.fields + "};\nOutputs main(" +
         inputs.parameters + ") {\n  Outputs result = (Outputs)0;\n" + body + outputs.statements +
         "  return result;\n}\n";
}

std::string MakeEntry(Context& context, const Program& program) {
  const bool distances = context.Chance(Feature::kDistances, 10);
  const std::string planes =
      context.Chance(Feature::kPlanes, 50)
          ? MakePlanes(context, program.buffers, program.lowering != "none", distances ? 4 : 6)
          : "";
  const ScopeOf scope(context);
  const EntryInputs inputs = MakeInputs(context, program.plane_space == "object");
  const Kind f = Kind::kFloat;
  const auto position = [&](int depth) {
    context.EndExpression();
    return "  result.position = " + Argument(MakeIn(context, f, {0, 4}, {-64, 64, 2}, depth)) +
           ";\n";
  };
  std::string body = position(1);
  body += MakeStatements(context, 10, 3);
  body += position(2);
  EntryOutputs outputs = MakeOutputs(context, program.is_soft);
  if (distances) {
    const bool culls = !planes.empty() || context.Chance(30);
    context.EndExpression();
    outputs.fields += std::string("  float2 distances : ") +
                      (culls ? "SV_CullDistance0" : "SV_ClipDistance0") + ";\n";
    outputs.statements +=
        "  result.distances = " + Argument(MakeIn(context, f, {0, 2}, {-64, 64, 2}, 2)) + ";\n";
  }
  return inputs.structs + "struct Outputs {\n  float4 position : SV_Position;\n" + outputs.fields +
         "};\n" + planes + "Outputs main(" + inputs.parameters +
         ") {\n  Outputs result = (Outputs)0;\n" + body + outputs.statements +
         "  return result;\n}\n";
}

// The planes of an entry that has no distances by hand.
std::string MakeSomePlanes(Context& context, const Program& program) {
  if (!context.Chance(Feature::kPlanes, 50)) return "";
  return MakePlanes(context, program.buffers, program.lowering != "none", 6);
}

// A stage, the feature that makes all programs its shaders, and what makes their entries.
struct StageRow {
  Stage stage;
  std::optional<Feature> feature;
  std::string (*make)(Context& context, const Program& program);
};
constexpr StageRow kStageRows[] = {
    {Stage::kPixel, Feature::kPixels,
     [](Context& context, const Program& program) {
       return kNeighbourObjects + MakePixelEntry(context, program);
     }},
    {Stage::kCompute, Feature::kGroups,
     [](Context& context, const Program&) { return MakeGroupEntry(context); }},
    {Stage::kGeometry, Feature::kEmitters,
     [](Context& context, const Program& program) {
       return MakeEmitterEntry(context, MakeSomePlanes(context, program));
     }},
    {Stage::kHull, Feature::kPatches,
     [](Context& context, const Program&) { return MakePatchEntry(context); }},
    {Stage::kDomain, Feature::kDomains,
     [](Context& context, const Program& program) {
       return MakeDomainEntry(context, MakeSomePlanes(context, program));
     }},
    {Stage::kVertex, std::nullopt, MakeEntry},
};

const StageRow& RowOf(const Features& features) {
  return *std::ranges::find_if(
      kStageRows, [&](const StageRow& row) { return !row.feature || features.Has(*row.feature); });
}

void ChooseOptions(Context& context, Program& program) {
  constexpr int kModels[] = {50, 50, 40, 41, 51, 60, 66};
  context.model = context.OneOf(kModels);
  program.stage = context.stage = RowOf(context.features).stage;
  const StageInfo& stage = clipc::InfoOf(program.stage);
  if (stage.makes_patches || stage.reads_patches) context.model = std::max(context.model, 50);
  program.profile = std::string(stage.prefix) + "_" + std::to_string(context.model / 10) + "_" +
                    std::to_string(context.model % 10);
  program.row_major = context.Chance(20);
  program.negative_one_to_one = context.Chance(30);
  program.flip_y = context.Chance(20);
  constexpr const char* kLowerings[] = {"clip-distance", "clip-distance", "clip-distance", "none"};
  program.lowering = context.OneOf(kLowerings);
  constexpr const char* kSpaces[] = {"clip", "clip", "clip", "xyw1", "object"};
  program.plane_space = context.OneOf(kSpaces);
  if (!stage.has_stage_after || stage.makes_patches) {
    program.lowering = "none";
    program.negative_one_to_one = false;
    program.flip_y &= !stage.makes_patches;
  }
  if (program.lowering == "none") program.plane_space = "clip";
  program.inputs = context.Below(1000);
  program.target = context.Below(60);
  program.is_soft = context.Chance(Feature::kSoftMath, 33);
  if (stage.reads_vertices) {
    // The vertices that the shader reads are not in object space.
    program.is_soft = false;
    if (program.plane_space == "object") program.plane_space = "clip";
  }
  if (stage.runs_in_groups) program.flip_y = program.is_soft = false;
}

}  // namespace

std::string Program::Options() const {
  std::string text = "-T " + profile + " --lower " + lowering;
  if (plane_space != "clip") text += " --plane-space " + plane_space;
  if (row_major) text += " --row-major";
  text += " --seed " + std::to_string(inputs) + " --random " + std::to_string(vertices);
  return text + " --quarters " + (is_soft ? "--ulps " + std::to_string(kSoftUlps) : "--exact");
}

Program MakeProgram(Choices& choices, const Features& features) {
  if (features.Has(Feature::kOnlyLoops)) return MakeLoops(choices, features);
  Context context(choices, features);
  context.scopes.emplace_back();
  Program program;
  ChooseOptions(context, program);
  if (features.Has(Feature::kStructs)) program.text += Some(context, 3, MakeStruct);
  program.text += MakeConstants(context, program.row_major, program.buffers);
  {
    const Temporarily no_effects(context.effects, false);
    program.text += Some(context, 3, MakeStatic);
  }
  if (features.Has(Feature::kFunctions)) program.text += Some(context, 4, MakeFunction);
  context.cost = 0;
  program.text += RowOf(features).make(context, program);
  program.structs = context.structs;
  WithMajors(program.structs, program.row_major);
  return program;
}

}  // namespace clipc::random
