// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/lower_program.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "compiler/compile/check_lowering.h"
#include "compiler/compile/fit_tessellation.h"
#include "compiler/compile/link_program.h"
#include "compiler/compile/write_spirv.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "ir/print.h"
#include "link/whole.h"

namespace clipc {
namespace {

// The number of planes for which a shader discards: those of the shader before.
std::size_t DiscardedPlanes(std::span<Job> jobs, const std::vector<ir::Program>& programs,
                            std::size_t number) {
  if (number == 0 || jobs[number - 1].plan.lowering.lowering != Lowering::kDiscard) return 0;
  return programs[number - 1].clip_planes.size();
}

// Fits a shader to what reads its outputs, and asks whether it fits the request. Returns the input
// with the position (FindPositionInput).
ir::VarId Fit(std::span<Job> jobs, std::size_t number, const std::vector<Lowered>& after,
              ir::Program& program, std::vector<std::string>& dependencies) {
  Job& job = jobs[number];
  const ProgramRequest& request = job.request;
  if (job.plan.keeps_matrices_whole)
    link::KeepMatricesWhole(program, !request.target.Has(glsl::Feature::kFullMatrices));
  if (!after.empty()) {
    LinkWithNext(job, jobs[number + 1], after.front(), program);
  } else if (request.neighbour) {
    LinkWithNeighbour(job, program, dependencies);
  }
  if (job.diagnostics.has_errors()) return {};
  if (number < request.PlaneStage()) {
    CheckPlanesMoved(program, jobs[request.PlaneStage()].plan.check, request.planes.in_last_stage,
                     job.diagnostics);
    return {};
  }
  const ir::VarId position_input = FindPositionInput(program, job.plan.lowering, job.diagnostics);
  if (!request.planes.given_to_device && !request.debug.changes_result())
    CheckPlanesAreKept(program, job.plan.lowering, request.target, job.diagnostics);
  return position_input;
}

LowerOptions OptionsOf(Job& job, std::size_t number, ir::VarId position_input, std::string& dump) {
  const ProgramRequest& request = job.request;
  LowerOptions options{request.target, {}, {}};
  // The shaders of a program are numbered together.
  if (request.shaders.size() > 1) options.target.bindings.later_base = 0;
  const OutputOptions& outputs = request.outputs;
  if (outputs.spirv && !outputs.glsl && !outputs.listing)
    options.needs = SpirvNeeds(options.target);
  passes::PipelineOptions& passes = options.passes;
  passes.clip_planes = {job.plan.lowering.lowering, job.plan.lowering.plane_space, position_input};
  // A stage that another one follows gives it the position as Direct3D has it, and one follows what
  // makes patches.
  const auto& stage = job.plan.check.profile.stage;
  const bool is_last = number >= request.PlaneStage() && !(stage && InfoOf(*stage).makes_patches);
  if (is_last) passes.clip_space = request.style.clip_space;
  passes.keeps_distances = !is_last;
  passes.precise_outputs = request.style.precise;
  static_cast<ir::PassOptions&>(passes) = PassesOf(job, dump);
  return options;
}

// Names the depth that nothing writes, since the tests run before the shader. OpenGL ES refuses to
// assign to it ("Early Fragment Tests" of GLSL ES 3.10), so that it is a local variable there.
void LeaveOutDepth(ir::Program& program, const glsl::Target& target, Diagnostics& diagnostics) {
  if (!program.tests_early) return;
  const auto depth = std::ranges::find_if(program.outputs, ir::IsDepth, &ir::IoVar::builtin);
  if (depth == program.outputs.end()) return;
  const ir::VarId var = depth->var;
  diagnostics.Report(program.vars[var].span, diag::DepthEarlyTests, depth->semantic);
  if (!target.IsEs()) return;
  program.outputs.erase(depth);
  program.vars[var].storage = ir::Storage::kLocal;
  std::vector<ir::StmtId> body = {
      ir::Builder(program, program.vars[var].span).Stmt(ir::Declare{var, {}})};
  const std::span<const ir::StmtId> old = ir::MainBody(program);
  body.insert(body.end(), old.begin(), old.end());
  ir::SetMainBody(program, body);
}

// Runs all passes, unless one stops them or the target cannot express the program.
Lowered LowerAlone(LinkedShader&& shader, const ProgramRequest& request, Diagnostics& diagnostics) {
  const ClipDistances distances = ClipDistancesOf(shader.program);
  Lowered lowered = Lower(std::move(shader.program), shader.options);
  if (!lowered.is_complete) return lowered;
  ReportLeftOut(distances, lowered.program, diagnostics);
  CheckEmission(lowered.program, diagnostics);
  CheckTarget(lowered, request.style.blocks, diagnostics);
  CheckBufferLayout(lowered.program, request.style.layout, diagnostics);
  if (const auto& spirv = request.outputs.spirv; spirv && !diagnostics.has_errors())
    CheckSpirv(lowered.program, lowered.target, *spirv, diagnostics);
  if (!diagnostics.has_errors()) Legalize(lowered, shader.options.passes);
  return lowered;
}

// Whether each shader becomes the same in every program of an effect in which the next stage reads
// the same of it.
bool CanShare(std::span<const Job> jobs) {
  const ProgramRequest& request = jobs.front().request;
  return !request.planes.variants && !request.neighbour && !request.link.keep_outputs &&
         jobs.front().plan.lowering.lowering != Lowering::kDiscard &&
         std::ranges::all_of(jobs, [](const Job& job) {
           return job.shader && !InfoOf(job.shader->program.stage).reads_vertices &&
                  !ReadsBuiltins(job.shader->program);
         });
}

// Lowers a shader for what reads its outputs, which is lowered, and puts it before that. Returns
// whether it has no errors.
bool LowerShader(std::span<Job> jobs, std::size_t number, std::vector<ir::Program>& programs,
                 LoweredProgram& lowered, CompileResult& result) {
  Job& job = jobs[number];
  const ProgramRequest& request = job.request;
  ir::Program& program = programs[number];
  const std::size_t written = program.outputs.size();
  const ir::VarId position = Fit(jobs, number, lowered.shaders, program, result.dependencies);
  if (job.diagnostics.has_errors()) return false;
  if (request.outputs.facts && InfoOf(program.stage).has_stage_after)
    lowered.position = FollowPosition(program);
  LowerOptions options = OptionsOf(job, number, position, result.dump);
  options.passes.drops_unneeded = number + 1 < jobs.size() && program.outputs.size() < written;
  options.passes.discarded_planes = DiscardedPlanes(jobs, programs, number);
  if (options.passes.discarded_planes > 0) CheckDiscards(program, job.diagnostics);
  LeaveOutDepth(program, request.target, job.diagnostics);
  LinkedShader shader{std::move(program), std::move(options)};
  if (request.planes.variants) lowered.linked.insert(lowered.linked.begin(), shader);
  lowered.shaders.insert(lowered.shaders.begin(),
                         LowerAlone(std::move(shader), request, job.diagnostics));
  return !job.diagnostics.has_errors() && !job.IsStopped();
}

// LowerShader, for a shader that other programs of the effect may have, too.
bool ShareShader(std::span<Job> jobs, std::size_t number, std::vector<ir::Program>& programs,
                 LoweredProgram& lowered, CompileResult& result) {
  Job& job = jobs[number];
  const bool is_last = number + 1 == jobs.size();
  const FittedShader* after = is_last ? nullptr : lowered.known[number + 1].get();
  const bool is_known = is_last || after;  // what it is fitted to
  if (is_known) lowered.known[number] = job.shader->Find(jobs.size(), after);
  if (const auto& known = lowered.known[number]) {
    lowered.shaders.insert(lowered.shaders.begin(), known->lowered);
    lowered.position = known->position;
    return true;
  }
  programs[number] = job.shader->program;
  const std::size_t messages = job.diagnostics.all().size();
  if (!LowerShader(jobs, number, programs, lowered, result)) return false;
  if (is_known && job.diagnostics.all().size() == messages) {
    lowered.known[number] =
        job.shader->Add(jobs.size(), after, lowered.shaders.front(), lowered.position);
  }
  return true;
}

}  // namespace

ir::PassOptions PassesOf(Job& job, std::string& dump) {
  const DebugOptions& debug = job.request.debug;
  if (!job.watch && debug.dump_after.empty()) return {job.plan.stop_after, debug.verify, {}};
  return {job.plan.stop_after, debug.verify,
          [&job, &dump](std::string_view pass, const ir::Program& after) {
            if (job.watch && job.watch->AskNow()) return false;
            const auto& wanted = job.request.debug.dump_after;
            if (std::ranges::find(wanted, pass) == wanted.end()) return true;
            if (wanted.size() > 1) dump += fmt::format("// after {}\n", pass);
            dump += ir::Print(after);
            return true;
          }};
}

std::optional<LoweredProgram> LowerProgram(std::span<Job> jobs, std::vector<ir::Program> programs,
                                           CompileResult& result) {
  LoweredProgram lowered;
  const bool can_share = CanShare(jobs);
  for (std::size_t i = 0; i < jobs.size(); ++i)
    if (jobs[i].shader && !can_share) programs[i] = jobs[i].shader->program;
  FitTessellation(jobs, programs);
  if (std::ranges::any_of(jobs, [](const Job& job) { return job.diagnostics.has_errors(); }))
    return std::nullopt;
  bool is_widened = false;
  for (std::size_t i = 1; i < programs.size(); ++i)
    is_widened |= FitDistances(programs[i - 1], programs[i]);
  // GLSL has the size of an array that not all is read of where all stages declare their vertices.
  for (Job& job : jobs) job.plan.write.separable |= is_widened;
  lowered.known.resize(jobs.size());
  lowered.shaders.reserve(jobs.size());
  for (std::size_t i = jobs.size(); i-- > 0;) {
    const bool is_lowered = can_share ? ShareShader(jobs, i, programs, lowered, result)
                                      : LowerShader(jobs, i, programs, lowered, result);
    if (!is_lowered) return std::nullopt;
  }
  const Lowered& first = lowered.shaders.front();
  if (first.is_complete) return lowered;
  if (jobs.front().request.debug.dump_after.empty()) result.dump = ir::Print(first.program);
  return std::nullopt;
}

std::vector<Lowered> LowerWithPlanes(std::vector<LinkedShader> linked, std::size_t planes) {
  std::vector<Lowered> lowered;
  for (LinkedShader& shader : linked) {
    if (shader.program.clip_planes.size() > planes) shader.program.clip_planes.resize(planes);
    passes::PipelineOptions& passes = shader.options.passes;
    passes.discarded_planes = std::min(passes.discarded_planes, planes);
    passes.after_pass = {};
    // CheckTarget has judged the shader with all planes.
    lowered.push_back(Lower(std::move(shader.program), shader.options));
    Legalize(lowered.back(), passes);
  }
  return lowered;
}

}  // namespace clipc
