// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <vector>

#include "backend-glsl/reach.h"
#include "ir/program.h"

// The stages of one program. Direct3D has registers for each stage; GLSL and Vulkan have one space
// of names and bindings for all. What stages declare alike is one block, texture or buffer of the
// program; everything else has a name and a place of its own.
namespace clipc::glsl {

struct GlslInfo;

// A stage and what it reaches.
struct ReachedStage {
  const ir::Program& program;
  Reached reached;
};

// What the layout of one stage must know about another. Ids are those of the stage that is laid
// out unless they say otherwise.
struct OtherStage {
  // By CbufferId the buffer of the other stage that is declared alike and that both stages read,
  // and by VarId such an object, or the same member of such a buffer; none for every other.
  std::vector<ir::CbufferId> cbuffers;
  std::vector<ir::VarId> vars;
  // Whether the other stage reads the member of such a buffer, by VarId: the layout of the block
  // depends on it.
  std::vector<bool> is_read;
  // Whether the other stage has clip or cull distances in gl_PerVertex, a block that both have.
  bool has_distances = false;
  const GlslInfo* laid = nullptr;  // what the other stage declares, if that is laid out before
};

// Every other stage of a program, in their order; empty where there is one stage only.
using OtherStages = std::span<const OtherStage>;

// Compares the buffers and objects of two stages. They are alike if name, type or members with
// their offsets, and register are the same; a register that is not written agrees with every other.
// Requires Form::kAddressed of both.
OtherStage CompareStages(const ReachedStage& stage, const ReachedStage& other);

}  // namespace clipc::glsl
