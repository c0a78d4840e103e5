// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/compile/count_matrices.h"
#include "compiler/compile/job.h"
#include "compiler/compile/known_shader.h"
#include "compiler/compile/result.h"
#include "compiler/compile/stages.h"
#include "ir/program.h"
#include "ir/run_passes.h"

// The way of all shaders of a program from Form::kResolved to what the writer prints: each is
// fitted to what reads its outputs, and then lowered alone. The last one is the first, as a stage
// that is lowered reads less.
namespace clipc {

// The passes' options of a job, which append the programs that the request wants to see to `dump`.
// Both must outlive them.
ir::PassOptions PassesOf(Job& job, std::string& dump);

// A shader that fits what reads its outputs, and how it is lowered.
struct LinkedShader {
  ir::Program program;
  LowerOptions options;
};

struct LoweredProgram {
  std::vector<Lowered> shaders;  // by stage
  // Of each, what is known of it from other programs of the effect; null: nothing.
  std::vector<std::shared_ptr<FittedShader>> known;
  std::vector<LinkedShader> linked;  // beside them, if they are to be lowered again
  PositionMatrices position;         // if facts are asked for
};

// Links and lowers the shaders. Returns nullopt after errors, and where the compile or the passes
// of the first shader were stopped.
std::optional<LoweredProgram> LowerProgram(std::span<Job> jobs, std::vector<ir::Program> programs,
                                           CompileResult& result);

// The same program with its first clip planes only: it has no errors that the whole one has not.
std::vector<Lowered> LowerWithPlanes(std::vector<LinkedShader> linked, std::size_t planes);

}  // namespace clipc
