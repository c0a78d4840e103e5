// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "ir/program.h"
#include "ir/run_passes.h"
#include "passes/adjust_clip_space.h"
#include "passes/lower_clip_planes.h"

namespace clipc::passes {

struct PipelineOptions : ir::PassOptions {
  ClipPlaneOptions clip_planes;
  ClipSpaceOptions clip_space;
  std::size_t discarded_planes = 0;  // a pixel shader's: the planes that DiscardPlanes knows
  bool keeps_distances = false;      // those that never clip too, for a stage that reads them
  bool precise_outputs = false;      // -Gis: outputs, and what goes into them, are precise
  bool drops_unneeded = false;       // for outputs that the pixel shader does not read
  bool hoist_loop_bounds = false;    // false where a loop must count to a constant
};

// Takes a program from Form::kResolved to Form::kInlined, unless `stop_after` ends it earlier.
// Returns whether all passes ran.
bool RunPipeline(ir::Program& program, const PipelineOptions& options);

// The names of the passes, in the order in which they run. --dump-after and --stop-after accept
// them.
std::vector<std::string_view> PassNames();

}  // namespace clipc::passes
