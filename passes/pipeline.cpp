// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/pipeline.h"

#include "base/invariant.h"
#include "passes/defer_discards.h"
#include "passes/discard_planes.h"
#include "passes/drop_idle_clip_distances.h"
#include "passes/drop_unneeded.h"
#include "passes/drop_unread.h"
#include "passes/drop_unread_arguments.h"
#include "passes/drop_unwritten.h"
#include "passes/hoist_loop_bounds.h"
#include "passes/inline_entry.h"
#include "passes/read_vertices.h"
#include "passes/split_variables.h"
#include "passes/spread_precise.h"
#include "passes/trace_interpolants.h"

namespace clipc::passes {
namespace {

// A program and the options with which the passes run on it.
struct Run {
  ir::Program& program;
  const PipelineOptions& options;
  MainParts parts = {};  // what inline-entry returns, for split-variables
};

// The order is the design. The comment on a pass says why the pass is at this place.
constexpr ir::Pass<Run> kPipeline[] = {
    // Planes are given in Direct3D clip space, so they are lowered before the depth range changes.
    {"lower-clip-planes", [](Run& run) { LowerClipPlanes(run.program, run.options.clip_planes); },
     ir::Form::kNoClipPlanes},
    // From here on the position is in the target's clip space.
    {"adjust-clip-space", [](Run& run) { AdjustClipSpace(run.program, run.options.clip_space); },
     ir::Form::kTargetClipSpace},
    // The passes before find each output written in one place, after the call of the entry point;
    // this one removes the call.
    {"inline-entry", [](Run& run) { run.parts = InlineEntry(run.program); }, ir::Form::kInlined},
    // The fields that the shader writes and those that `main` reads and writes are in one function
    // only now. No pass between the two moves the parts of `main`.
    {"split-variables", [](Run& run) { SplitVariables(run.program, run.parts); },
     ir::Form::kInlined},
    // The array of a primitive's vertices is a local variable of `main`, with all its uses, only
    // now.
    {"read-vertices", [](Run& run) { ReadVertices(run.program); }, ir::Form::kInlined},
    // Distances that the shader writes by hand have their constants in `main` only now.
    {"drop-idle-clip-distances",
     [](Run& run) {
       if (!run.options.keeps_distances) DropIdleClipDistances(run.program);
     },
     ir::Form::kInlined},
    // An entry function that keeps its call has an argument for each input only now, and does not
    // read any more what this pass names.
    {"trace-interpolants", [](Run& run) { TraceInterpolants(run.program); }, ir::Form::kInlined},
    // `main` need not read the inputs that an entry function that keeps its call does not read.
    {"drop-unread-arguments", [](Run& run) { DropUnreadArguments(run.program); },
     ir::Form::kInlined},
    {"drop-unwritten", [](Run& run) { DropUnwritten(run.program); }, ir::Form::kInlined},
    // Outputs that the pixel shader does not read are local variables, whole ones only now.
    {"drop-unneeded",
     [](Run& run) {
       if (run.options.drops_unneeded) DropUnneeded(run.program);
     },
     ir::Form::kInlined},
    // Variables become unread where the passes before have removed statements.
    {"drop-unread", [](Run& run) { DropUnread(run.program); }, ir::Form::kInlined},
    // The distances are inputs, which no pass before has to carry along; whether the discard must
    // wait is for the next pass to say.
    {"discard-planes", [](Run& run) { DiscardPlanes(run.program, run.options.discarded_planes); },
     ir::Form::kInlined},
    // Samples that the passes before have removed need no neighbours.
    {"defer-discards", [](Run& run) { DeferDiscards(run.program); }, ir::Form::kInlined},
    // Calls that the passes before have removed need not be followed.
    {"spread-precise", [](Run& run) { SpreadPrecise(run.program, run.options.precise_outputs); },
     ir::Form::kInlined},
    // Loops that the passes before have removed have no bounds to read.
    {"hoist-loop-bounds",
     [](Run& run) {
       if (run.options.hoist_loop_bounds) HoistLoopBounds(run.program);
     },
     ir::Form::kInlined},
};

}  // namespace

bool RunPipeline(ir::Program& program, const PipelineOptions& options) {
  CLIPC_CHECK(program.form == ir::Form::kResolved);
  ir::VerifyAfter("checking", program, ir::Form::kResolved, options);
  Run run{program, options};
  return ir::RunPasses<Run>(program, kPipeline, run, options);
}

std::vector<std::string_view> PassNames() {
  std::vector<std::string_view> names;
  for (const auto& pass : kPipeline) names.push_back(pass.name);
  return names;
}

}  // namespace clipc::passes
