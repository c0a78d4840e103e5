// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/resolve.h"

#include "frontend/resolve/compare_samplers.h"
#include "frontend/resolve/counters.h"
#include "frontend/resolve/fold_arguments.h"
#include "frontend/resolve/known_offsets.h"
#include "frontend/resolve/lower_streams.h"
#include "frontend/resolve/mark_coherent.h"
#include "frontend/resolve/mark_nonuniform.h"
#include "frontend/resolve/settle_samplers.h"
#include "frontend/rules/check_gradients.h"
#include "frontend/rules/check_groups.h"
#include "frontend/rules/check_level9.h"
#include "frontend/rules/check_object_indices.h"
#include "frontend/rules/check_written.h"
#include "frontend/rules/push_constants.h"

namespace clipc::resolve {
namespace {

// A program and what its passes and checks need.
struct Run {
  Program& program;
  const ResolveOptions& options;
  Diagnostics& diagnostics;
};

// The order is the design. The comment on a pass says why the pass is at this place. An error ends
// them.
constexpr Pass<Run> kPasses[] = {
    // A parameter that only a removed branch would write is written, for fxc too; and what one
    // iteration of a loop writes the next may read, until offsets unroll the loop.
    {"check-written", [](Run& run) { CheckWritten(run.program, run.diagnostics); }, Form::kTyped},
    // Branches that the arguments of a technique remove choose no objects.
    {"fold-arguments",
     [](Run& run) {
       if (run.options.is_specialised) FoldArguments(run.program);
     },
     Form::kTyped},
    // Unrolled loops make indices literals, and constants of calls make choices known; the object
    // is the same on all paths only then.
    {"know-object-indices", [](Run& run) { KnowObjectIndices(run.program, run.diagnostics); },
     Form::kTyped},
    {"fold-object-choices", [](Run& run) { FoldObjectChoices(run.program); }, Form::kTyped},
    {"resolve-objects",
     [](Run& run) { ResolveObjects(run.program, run.options.struct_registers, run.diagnostics); },
     Form::kTyped},
    // A stream is one of the entry's parameters only now.
    {"lower-streams", [](Run& run) { LowerStreams(run.program, run.diagnostics); }, Form::kTyped},
    // The passes from here on ask which variable an object is.
    {"settle-samplers",
     [](Run& run) {
       SettleSamplers(run.program, run.diagnostics);
       run.program.form = Form::kResolved;
     },
     Form::kResolved},
    // A sampler has its kind only now.
    {"compare-samplers",
     [](Run& run) { CompareSamplers(run.program, run.options.shadow_samplers, run.diagnostics); },
     Form::kResolved},
    {"make-counters", [](Run& run) { MakeCounters(run.program, run.diagnostics); },
     Form::kResolved},
    {"know-offsets", [](Run& run) { KnowOffsets(run.program, run.diagnostics); }, Form::kResolved},
    // Indices in unrolled loops are literals, which are the same for all invocations.
    {"mark-nonuniform", [](Run& run) { MarkNonUniform(run.program); }, Form::kResolved},
    {"mark-coherent", [](Run& run) { MarkCoherent(run.program); }, Form::kResolved},
};

// Registers are chosen for what the passes before leave, and after errors too: a program with an
// error shows those of its registers.
constexpr Pass<Run> kAssignRegisters = {
    "assign-registers",
    [](Run& run) {
      CheckPushConstants(run.program, run.diagnostics);
      AssignRegisters(run.program, run.options.registers_of_unused(), run.diagnostics);
    },
    Form::kResolved};

// The checks of a program in Form::kResolved, in the order of their messages. An error ends them.
constexpr void (*kChecks[])(const Run&) = {
    [](const Run& run) { CheckLevel9(run.program, run.options.has_preshader, run.diagnostics); },
    [](const Run& run) { CheckGradients(run.program, run.diagnostics); },
    [](const Run& run) { CheckGroups(run.program, run.diagnostics); },
    [](const Run& run) { CheckObjectIndices(run.program, run.diagnostics); },
};

}  // namespace

void Resolve(Program& program, const ResolveOptions& options, const PassOptions& passes,
             Diagnostics& diagnostics) {
  Run run{program, options, diagnostics};
  for (const auto& pass : kPasses) {
    if (diagnostics.has_errors()) break;
    pass.run(run);
    if (!diagnostics.has_errors() && !FinishPass(program, pass.name, pass.ensures, passes)) return;
  }
  kAssignRegisters.run(run);
  if (diagnostics.has_errors()) return;
  if (!FinishPass(program, kAssignRegisters.name, kAssignRegisters.ensures, passes)) return;
  for (const auto& check : kChecks) {
    if (!diagnostics.has_errors()) check(run);
  }
}

std::vector<std::string_view> ResolvePasses() {
  std::vector<std::string_view> names;
  for (const auto& pass : kPasses) names.push_back(pass.name);
  names.push_back(kAssignRegisters.name);
  return names;
}

}  // namespace clipc::resolve
