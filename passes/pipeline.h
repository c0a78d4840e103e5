// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/program.h"
#include "passes/adjust_clip_space.h"
#include "passes/lower_clip_planes.h"

namespace clipc::passes {

struct PipelineOptions {
  ClipPlaneOptions clip_planes;
  ClipSpaceOptions clip_space;
  std::string stop_after;  // the name of the last pass that runs; empty: all run
  bool verify =
      false;  // ir::Verify before the first pass and after each; builds with assertions always do
  // Called when a pass is done, with its name: --dump-after prints the program here.
  std::function<void(std::string_view pass, const ir::Program&)> after_pass;
};

// Takes a program from Form::kTyped to Form::kInlined, unless `stop_after` ends it earlier.
void RunPipeline(ir::Program& program, const PipelineOptions& options);

// What --dump-after and --stop-after accept, in the order in which the passes run.
std::vector<std::string_view> PassNames();

}  // namespace clipc::passes
