// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <vector>

#include "frontend/check/context.h"

// The rules of [clipplanes(...)], each with a message of its own.
namespace clipc::check {

// The attributes of a function: the list of its definition, then those of its prototypes.
using AttributeLists = std::vector<std::span<const ast::Attr>>;
AttributeLists AttributesOf(const Context& context, FunctionInfoId function);

// Reaches the buffers that the clip planes of the entry point lie in, whether or not the code reads
// them.
void ReachClipPlanes(Context& context, FunctionInfoId entry, const AttributeLists& attributes);

// Checks the clip plane attributes of the entry point and fills program.clip_planes. Requires
// program.outputs (BuildMain ran) and laid out cbuffers.
void CheckClipPlanes(Context& context, FunctionInfoId entry, const AttributeLists& attributes);

// For a function that is not the entry point: warns of a clip plane attribute (X3588), which has no
// effect there, and reports a misspelt one.
void CheckUnusedClipPlanes(Context& context, const ast::FunctionDecl& function);

}  // namespace clipc::check
