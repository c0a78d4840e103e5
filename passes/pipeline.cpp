// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/pipeline.h"

#include <cstdio>
#include <cstdlib>
#include <optional>

#include "base/invariant.h"
#include "ir/print.h"
#include "ir/verify.h"
#include "passes/drop_idle_clip_distances.h"
#include "passes/drop_unread.h"
#include "passes/drop_unread_arguments.h"
#include "passes/inline_entry.h"

namespace clipc::passes {
namespace {

struct Pass {
  std::string_view name;
  void (*run)(ir::Program&, const PipelineOptions&);
  ir::Form ensures;
};

// The order is the design. Each line says why it stands where it stands.
constexpr Pass kPipeline[] = {
    // Planes are given in Direct3D clip space, so before the depth range changes.
    {"lower-clip-planes",
     [](ir::Program& program, const PipelineOptions& options) {
       LowerClipPlanes(program, options.clip_planes);
     },
     ir::Form::kNoClipPlanes},
    // From here on the position is in the target's clip space.
    {"adjust-clip-space",
     [](ir::Program& program, const PipelineOptions& options) {
       AdjustClipSpace(program, options.clip_space);
     },
     ir::Form::kTargetClipSpace},
    // The passes before find each output written in one place, after the call of the entry point;
    // this one removes the call.
    {"inline-entry", [](ir::Program& program, const PipelineOptions&) { InlineEntry(program); },
     ir::Form::kInlined},
    // Distances that the shader writes by hand have their constants in `main` only now.
    {"drop-idle-clip-distances",
     [](ir::Program& program, const PipelineOptions&) { DropIdleClipDistances(program); },
     ir::Form::kInlined},
    // What an entry function that keeps its call does not read, `main` need not read either.
    {"drop-unread-arguments",
     [](ir::Program& program, const PipelineOptions&) { DropUnreadArguments(program); },
     ir::Form::kInlined},
    // After everything that removes statements.
    {"drop-unread", [](ir::Program& program, const PipelineOptions&) { DropUnread(program); },
     ir::Form::kInlined},
};

#ifdef NDEBUG
constexpr bool kHasAssertions = false;
#else
constexpr bool kHasAssertions = true;
#endif

// An invariant of clipc that is broken: says which and after what, shows the program, and aborts.
void VerifyAfter(std::string_view step, const ir::Program& program, ir::Form form) {
  const std::optional<std::string> problem = ir::Verify(program, form);
  if (!problem) return;
  std::fprintf(stderr, "clipc invariant broken after %.*s: %s\n%s\n", static_cast<int>(step.size()),
               step.data(), problem->c_str(), ir::Print(program).c_str());
  std::abort();
}

}  // namespace

void RunPipeline(ir::Program& program, const PipelineOptions& options) {
  CLIPC_CHECK(program.form == ir::Form::kTyped);
  const bool verify = kHasAssertions || options.verify;
  if (verify) VerifyAfter("checking", program, ir::Form::kTyped);
  for (const Pass& pass : kPipeline) {
    pass.run(program, options);
    CLIPC_CHECK(program.form == pass.ensures);
    if (verify) VerifyAfter(pass.name, program, pass.ensures);
    if (options.after_pass) options.after_pass(pass.name, program);
    if (options.stop_after == pass.name) return;
  }
}

std::vector<std::string_view> PassNames() {
  std::vector<std::string_view> names;
  for (const Pass& pass : kPipeline) names.push_back(pass.name);
  return names;
}

}  // namespace clipc::passes
