// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/link_program.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "compiler/compile/neighbour.h"
#include "ir/intrinsic.h"
#include "ir/walk.h"
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

// An output that GLSL has a variable for, and the input that it becomes.
struct PassedOn {
  ir::Builtin output, input;
};
constexpr PassedOn kPassedOn[] = {{ir::Builtin::kPosition, ir::Builtin::kPositionInput},
                                  {ir::Builtin::kPointSize, ir::Builtin::kPointSizeInput},
                                  {ir::Builtin::kClipDistance, ir::Builtin::kClipDistanceInput},
                                  {ir::Builtin::kCullDistance, ir::Builtin::kCullDistanceInput},
                                  {ir::Builtin::kPrimitiveIdOutput, ir::Builtin::kPrimitiveId}};

const ir::IoVar* Find(const ir::IoVars& list, ir::Builtin builtin) {
  const auto found = std::ranges::find(list, builtin, &ir::IoVar::builtin);
  return found == list.end() ? nullptr : &*found;
}

// The number of distances; 1 of another variable.
std::uint32_t CountOf(const ir::Program& program, const ir::IoVar& io) {
  const ir::Type& type = program.types[program.vars[io.var].type];
  return type.kind == ir::TypeKind::kArray ? type.count : 1;
}

// The number of distances that the lowering makes of the clip planes, in every variant.
std::size_t PlaneDistances(const Job& job, const ir::Program& program) {
  const bool are_written =
      job.plan.lowering.lowering == Lowering::kClipDistance && !job.request.planes.variants;
  return are_written ? program.clip_planes.size() : 0;
}

// The tools below match variables by semantic, location or name, which these do not have in GLSL.
void CheckBuiltins(Job& job, const ir::Program& program, const ir::Program& next) {
  for (const auto& [output, input] : kPassedOn) {
    const ir::IoVar* read = Find(next.inputs, input);
    // Only a stage that emits primitives gives them numbers.
    const bool is_given = input == ir::Builtin::kPrimitiveId && program.emission.streams.empty();
    if (!read || is_given) continue;
    const ir::IoVar* written = Find(program.outputs, output);
    std::size_t count = written ? CountOf(program, *written) : 0;
    if (output == ir::Builtin::kClipDistance) count = std::max(count, PlaneDistances(job, program));
    const std::uint32_t needed = CountOf(next, *read);
    if (count >= needed) continue;
    const std::string what = count == 0
                                 ? fmt::format("`{}`", read->semantic)
                                 : fmt::format("component {} of `{}`", count, read->semantic);
    job.diagnostics.Report(program.functions[program.entry].span, diag::BuiltinUnwritten,
                           InfoOf(program.stage).name, what, InfoOf(next.stage).name);
  }
}

// Gives an array that is read at each vertex the number of elements that are written.
void Widen(ir::Program& program, ir::VarId input, std::uint32_t count) {
  const ir::TypeId type =
      program.types.Array(program.types[program.vars[input].type].element, count);
  program.vars[input].type = type;
  const auto is_input = [&](ir::ExprId expr) {
    const auto* ref = ir::As<ir::VarRef>(program, expr);
    return ref && ref->var == input;
  };
  ir::ForEachLiveExpr(program, [&](ir::ExprId id) {
    const auto* call = ir::As<ir::IntrinsicCall>(program, id);
    const bool is_read = call && call->op == ir::CommonIntrinsic::kInputOfVertex &&
                         is_input(program.expr_lists[call->arguments][0]);
    if (is_read || is_input(id)) program.exprs[id].type = type;
  });
}

}  // namespace

bool ReadsBuiltins(const ir::Program& program) {
  return std::ranges::any_of(
      kPassedOn, [&](const PassedOn& pair) { return Find(program.inputs, pair.input) != nullptr; });
}

bool WidenDistances(const ir::Program& before, ir::Program& program) {
  bool is_any = false;
  if (!InfoOf(program.stage).reads_vertices) return is_any;
  for (const auto& [output, input] : kPassedOn) {
    const ir::IoVar* read = Find(program.inputs, input);
    const ir::IoVar* written = Find(before.outputs, output);
    if (!read || !written) continue;
    const std::uint32_t count = CountOf(before, *written);
    if (count <= CountOf(program, *read)) continue;
    Widen(program, read->var, count);
    is_any = true;
  }
  return is_any;
}

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
  CheckBuiltins(job, program, next.program);
  if (!job.diagnostics.has_errors()) link::Apply(program, reader, matches, options);
}

}  // namespace clipc
