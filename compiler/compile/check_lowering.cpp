// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/check_lowering.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/spelling.h"
#include "frontend/signature/position_input.h"
#include "ir/access.h"
#include "passes/outputs.h"

namespace clipc {
namespace {

// Planes that become clip distances share the eight distances with the shader's own cull distances.
void CheckDistanceCount(const ir::Program& program, std::uint32_t least, Diagnostics& diagnostics) {
  const auto planes = static_cast<std::uint32_t>(program.clip_planes.size());
  if (least > 0 && planes > least)
    diagnostics.Report(program.clip_planes[least].span, diag::RewriteFewDistances, planes, least);
  const ir::VarId culls = passes::FindOutput(program, ir::Builtin::kCullDistance);
  if (!culls) return;
  const std::uint32_t count =
      std::max(planes, least) + program.types[program.vars[culls].type].count;
  if (count <= kMaxClipDistances) return;
  diagnostics.Report(program.clip_planes.front().span, diag::TooManyClipDistances, count)
      .Note(program.vars[culls].span, diag::CullDistanceWrittenHere);
}

}  // namespace

Lowering DefaultLowering(const ir::Profile& profile) {
  return profile.level9 == ir::Level9::kNone ? Lowering::kClipDistance : Lowering::kLevel9;
}

void CheckRequest(const LoweringRequest& request, Diagnostics& diagnostics) {
  if (Supports(request.lowering, request.plane_space)) return;
  diagnostics.Report({}, diag::PlaneSpaceLowering, NameOf(request.plane_space),
                     NameOf(request.lowering));
}

void CheckHlslRequest(const LoweringRequest& request, Diagnostics& diagnostics) {
  if (request.lowering == Lowering::kLevel9) diagnostics.Report({}, diag::RewriteLevel9);
}

ir::VarId FindPositionInput(const ir::Program& program, const LoweringRequest& request,
                            Diagnostics& diagnostics) {
  const auto& planes = program.clip_planes;
  if (planes.empty()) return {};
  if (request.lowering == Lowering::kNone) {
    diagnostics.Report(Cover(planes.front().span, planes.back().span), diag::ClipPlanesIgnored,
                       WithCount(planes.size(), "clip plane"));
  }
  if (request.lowering == Lowering::kNearPlane && planes.size() > 1) {
    diagnostics.Report(planes[1].span, diag::ClipPlanesForNearPlane, planes.size());
    return {};
  }
  if (request.lowering == Lowering::kClipDistance)
    CheckDistanceCount(program, request.distances, diagnostics);
  if (request.plane_space != PlaneSpace::kObject) return {};
  const std::string& semantic = request.position_input;
  return signature::CheckPositionInput(program, semantic.empty() ? "POSITION0" : semantic,
                                       diagnostics);
}

void CheckPlanesAreKept(const ir::Program& program, const LoweringRequest& request,
                        const glsl::Target& target, Diagnostics& diagnostics) {
  const auto& planes = program.clip_planes;
  const bool is_kept = request.lowering != Lowering::kLevel9 || planes.empty() ||
                       target.Has(glsl::Feature::kClipVertex);
  if (is_kept) return;
  diagnostics.Report(Cover(planes.front().span, planes.back().span), diag::ClipPlanesOnlyInTable);
}

void CheckPlanesMoved(const ir::Program& program, const CheckOptions& last, bool are_moved,
                      Diagnostics& diagnostics) {
  const auto& planes = program.clip_planes;
  const bool is_last = !InfoOf(*last.profile.stage).makes_patches;
  if ((are_moved && is_last) || planes.empty()) return;
  diagnostics.Report(
      Cover(planes.front().span, planes.back().span), diag::ClipPlanesBeforeLast, last.entry,
      is_last ? " and writes the positions that are drawn; `--planes-in-last-stage` clips there"
              : ", and a domain shader after it writes the positions that are drawn; compile that "
                "in the same command, with `--planes-in-last-stage`");
}

// [earlydepthstencil] forces the depth-stencil test, with its writes, before the shader (Direct3D
// 11.3, 15.3.4 "Force Early Depth/Stencil Test"; GL_ARB_shader_image_load_store: a fragment that is
// discarded afterwards has updated the buffers).
void CheckEmission(const ir::Program& lowered, Diagnostics& diagnostics) {
  constexpr std::uint32_t kGuaranteed = 256;
  const std::uint32_t vertices = lowered.emission.max_vertices;
  if (!InfoOf(lowered.stage).emits_vertices) return;
  const Span span = lowered.functions[lowered.entry].span;
  const std::int64_t scalars = ir::ScalarsOfVertex(lowered);
  if (scalars * vertices > ir::kMostScalarsEmitted) {
    diagnostics
        .Report(span, diag::EmissionTooLarge, vertices, scalars, scalars * vertices,
                ir::kMostScalarsEmitted)
        .Note({}, diag::PlainNote,
              fmt::format("{} of the scalars are clip distances", lowered.clip_planes.size()));
  }
  if (vertices > kGuaranteed)
    diagnostics.Report(span, diag::EmissionBeyondGuaranteed, vertices, kGuaranteed);
}

void CheckDiscards(const ir::Program& pixel, Diagnostics& diagnostics) {
  if (!pixel.tests_early) return;
  const ir::Function& entry = pixel.functions[pixel.entry];
  diagnostics.Report(entry.span, diag::DiscardEarlyTests, "earlydepthstencil");
}

ClipDistances ClipDistancesOf(const ir::Program& program) {
  const ir::VarId output = passes::FindOutput(program, ir::Builtin::kClipDistance);
  if (!output) return {};
  return {output, program.types[program.vars[output].type].count};
}

void ReportLeftOut(const ClipDistances& before, const ir::Program& lowered,
                   Diagnostics& diagnostics) {
  const std::uint32_t left = ClipDistancesOf(lowered).count;
  if (!before.output || left == before.count) return;
  diagnostics.Report(lowered.vars[before.output].span, diag::ClipDistancesLeftOut, left);
}

}  // namespace clipc
