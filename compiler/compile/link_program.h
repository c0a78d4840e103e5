// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "compiler/compile/job.h"
#include "compiler/compile/stages.h"
#include "ir/program.h"

// The fit of a stage to what reads its outputs: outputs that nothing reads are dropped, and the
// rest has the names, places and types of the inputs (link/match.h). Each function requires
// Form::kResolved of the program, which is as it was after errors.
namespace clipc {

// Fits the program to the request's neighbour. Appends the files that were read to `dependencies`.
void LinkWithNeighbour(Job& job, ir::Program& program, std::vector<std::string>& dependencies);

// Makes a stage read its clip and cull distances where the stage before writes those of the same
// semantics: GLSL has one array of them. Those that are read at each vertex get the number of
// elements that is written, since OpenGL links arrays of one size. Returns whether one was smaller.
bool FitDistances(const ir::Program& before, ir::Program& program);

// Whether the program reads what the stage before writes to a variable of GLSL's own.
bool ReadsBuiltins(const ir::Program& program);

// Fits the program to the stage after it, which is lowered.
void LinkWithNext(Job& job, Job& next_job, const Lowered& next, ir::Program& program);

}  // namespace clipc
