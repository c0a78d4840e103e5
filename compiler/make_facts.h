// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "clip-table/clip_table.h"
#include "compiler/count_matrices.h"
#include "compiler/facts.h"
#include "compiler/stages.h"

namespace clipc {

// A stage as it was written.
struct DescribedStage {
  const Lowered& lowered;
  const glsl::GlslInfo& info;
  const clip_table::ClipTable& table;
};
// Describes a shader, and the pixel shader of a pair.
Facts MakeFacts(const DescribedStage& stage, const PositionMatrices& position,
                const DescribedStage* pixel = nullptr);

}  // namespace clipc
