// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/link_program.h"

#include <algorithm>

#include "compiler/compile/neighbour.h"
#include "link/match.h"
#include "link/read.h"

namespace clipc {
namespace {

// Forgets names that the request knows better: those of HLSL and SPIR-V depend on what is made of
// them.
void ForgetNames(link::Interface& neighbour, bool is_glsl) {
  for (link::Input& input : neighbour.inputs) {
    if (!input.group && (input.location || !is_glsl)) input.name.clear();
  }
  for (link::UniformBlock& block : neighbour.blocks) {
    if (!is_glsl) block.name.clear();
  }
}

// Makes what the rasteriser alone reads a value like any other, before a stage that reads it from
// vertices: there Direct3D passes it on ("Signature Points" of DXC's DXIL.rst: SV of VSOut, HSIn
// and GSVIn), and GLSL does not.
void PassToNext(ir::Program& program) {
  for (ir::IoVar& output : program.outputs) {
    if (output.builtin == ir::Builtin::kLayer || output.builtin == ir::Builtin::kViewportIndex)
      output.builtin = ir::Builtin::kNone;
  }
}

// After a geometry shader the number of the primitive is what that shader writes.
void CheckPrimitiveId(const ir::Program& program, const ir::Program& next,
                      Diagnostics& diagnostics) {
  if (program.emission.streams.empty()) return;
  const auto read = std::ranges::find(next.inputs, ir::Builtin::kPrimitiveId, &ir::IoVar::builtin);
  if (read == next.inputs.end() ||
      std::ranges::find(program.outputs, ir::Builtin::kPrimitiveIdOutput, &ir::IoVar::builtin) !=
          program.outputs.end())
    return;
  diagnostics.Report(program.functions[program.entry].span, diag::PixelInputUnwritten,
                     InfoOf(program.stage).name, InfoOf(next.stage).name, read->semantic);
}

}  // namespace

void LinkWithNeighbour(Job& job, ir::Program& program, std::vector<std::string>& dependencies) {
  const ProgramRequest& request = job.request;
  const glsl::Target& target = request.target;
  link::ReadResult neighbour = ReadNeighbour(request, dependencies);
  if (!neighbour.problems.empty()) {
    const std::vector<std::string>& problems = neighbour.problems;
    Diagnostic& report = job.diagnostics.Report({}, diag::PixelShader, problems.front());
    for (std::size_t i = 1; i < problems.size(); ++i) report.Note({}, diag::PlainNote, problems[i]);
    return;
  }
  // Drivers of desktop OpenGL link a program by name whose pixel shader reads what nothing writes.
  const bool links_by_name = !target.IsEs() && target.Has(glsl::Feature::kInAndOut) &&
                             !target.Has(glsl::Feature::kOutputLocations);
  const link::MatchOptions options{request.link.keep_outputs, target.IsVulkan(),
                                   request.link.zero_unwritten || links_by_name, target.IsEs()};
  const link::Matches matches = link::Match(program, neighbour.interface, options, job.diagnostics);
  if (job.diagnostics.has_errors()) return;
  if (!request.style.names.empty()) ForgetNames(neighbour.interface, neighbour.is_glsl);
  link::Apply(program, neighbour.interface, matches, options);
}

void LinkWithNext(Job& job, Job& next_job, const Lowered& next, ir::Program& program) {
  const LinkOptions& link = job.request.link;
  if (InfoOf(next.program.stage).has_stage_after) PassToNext(program);
  const link::Interface reader =
      link::ReadInputs(next.program, [&](Span span) { return next_job.PlaceOf(span); });
  // The next stage declares what it reads and nothing else, for Vulkan too.
  const link::MatchOptions options{.keep_outputs = link.keep_outputs,
                                   .zero_unwritten = link.zero_unwritten,
                                   .is_es = job.request.target.IsEs()};
  const link::Matches matches = link::Match(program, reader, options, job.diagnostics);
  CheckPrimitiveId(program, next.program, job.diagnostics);
  if (!job.diagnostics.has_errors()) link::Apply(program, reader, matches, options);
}

}  // namespace clipc
