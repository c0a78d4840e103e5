// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <set>
#include <string>
#include <vector>

#include "ir/program.h"
#include "tools/draw/random_inputs.h"
#include "tools/reference-compiler/relocate.h"

// The known bugs of glslang 12's HLSL front end, which differs from Direct3D there.
// docs/reference-compilers.md says for each bug why it is the reference compiler that is wrong. A
// bug excuses a difference only where clipc's program, changed to do the same, gives exactly what
// the reference compiler gives. The exceptions are two bugs that compare.cpp tells by the shader's
// text, and one that it tells by members that overlap.
namespace clipc::draw::reference_compiler {

// Sets the constants of `random` that the reference compiler compiled in, for which it has no
// uniform, to the values that it took: the initial values of global variables, read from `hlsl`.
// Returns whether there are any.
bool GiveInitialValues(const ir::Program& program, const std::vector<ReferenceBlock>& blocks,
                       const std::string& hlsl, RandomInputs& random);

// Rewrites the shader into what the reference compiler makes of it, bug by bug, and returns their
// names.
std::set<std::string> ApplyValueBugs(ir::Program& program);

}  // namespace clipc::draw::reference_compiler
