// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

#include "clip-table/clip_table.h"
#include "compiler/compile/count_matrices.h"
#include "compiler/compile/facts.h"
#include "compiler/compile/stages.h"

namespace clipc {

// A stage as it was written.
struct DescribedStage {
  const Lowered& lowered;
  const glsl::GlslInfo& info;
  clip_table::ClipTable table;
};
// Describes the shaders of a program. `position` is that of the stage before the rasterizer.
Facts MakeFacts(std::span<const DescribedStage> stages, const PositionMatrices& position);

}  // namespace clipc
