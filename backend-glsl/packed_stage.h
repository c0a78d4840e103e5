// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <vector>

#include "backend-glsl/block_layout.h"
#include "backend-glsl/other_stage.h"
#include "backend-glsl/reach.h"
#include "backend-glsl/target.h"
#include "ir/program.h"

namespace clipc::glsl {

// A stage whose constant buffers are laid out. Members that GLSL cannot declare at their places are
// read by functions of the program out of what GLSL declares there, as are blocks as a whole:
// legalize/read_members.h.
struct PackedStage {
  // `program` outlives the stage. Stages lay out a block that they share by what any of them reads.
  PackedStage(const ir::Program& program, const Target& target, BlockStyle style,
              OtherStages others);

  // The program, or the copy in which functions read members.
  const ir::Program& program() const { return copy ? *copy : given; }

  const ir::Program& given;
  Reached reached;
  std::vector<BlockLayout> layouts;  // by CbufferId, of the reached ones
  std::optional<ir::Program> copy;
  std::vector<ir::FunctionId> readers;  // by VarId: those functions
};

}  // namespace clipc::glsl
