// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "ir/program.h"
#include "link/interface.h"
#include "link/matches.h"

// The matching of a vertex shader with a pixel shader: of outputs with inputs, and of constant
// buffers.
namespace clipc::link {

// Finds the outputs and the constant buffers that the pixel shader's inputs and blocks match.
// Inputs with a semantic match the output of that semantic, or of their [[vk::location]]. Others
// match, in this order of belief, an output whose semantic or member of a struct their name was
// made of by DXC, glslang, SPIRV-Cross or HLSLcc, the output of their location, or the outputs that
// are left, in their order, if those are as many and of the same types. Reports an input that
// nothing writes (as a warning with MatchOptions::zero_unwritten), types that cannot fit, and a
// constant buffer that both declare with different members. Requires Form::kResolved.
Matches Match(const ir::Program& program, const Interface& pixel, const MatchOptions& options,
              Diagnostics& diagnostics);

// Gives the outputs and constant buffers the names, places and shapes of the inputs and blocks that
// they match. Removes the outputs that match nothing, unless they are built in or
// MatchOptions::keep_outputs is set. Requires matches without errors. Requires and ensures
// Form::kResolved.
void Apply(ir::Program& program, const Interface& pixel, const Matches& matches,
           const MatchOptions& options);

}  // namespace clipc::link
