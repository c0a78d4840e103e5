// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <vector>

#include "frontend/check/context.h"

// The rules of [clipplanes(...)], each with a message of its own.
namespace clipc::check {

// The attributes of a function: the list of its definition, then the lists of its prototypes.
using AttributeLists = std::vector<std::span<const ast::Attr>>;
AttributeLists AttributesOf(const Context& context, FunctionInfoId function);
// Whether an attribute of the name, in any case, is among them.
// The first attribute of the name, of any case; null if there is none.
const ast::Attr* FindAttribute(const Context& context, const AttributeLists& attributes,
                               std::string_view name);
// The arguments of an attribute as text.
std::string OperandsAsText(const Context& context, const ast::Attr& attr);
bool HasAttribute(const Context& context, const AttributeLists& attributes, std::string_view name);

// Reaches the buffers that the clip planes of the entry point lie in, whether or not the code reads
// them.
void ReachClipPlanes(Context& context, FunctionInfoId entry, const AttributeLists& attributes);

// Checks the clip plane attributes of the entry point and fills program.clip_planes. Requires
// program.outputs (BuildMain ran) and laid out cbuffers.
void CheckClipPlanes(Context& context, FunctionInfoId entry, const AttributeLists& attributes);

// Warns of clip planes on functions other than the entry point (X3588), where they have no effect,
// and reports attributes there whose spelling is close to `clipplanes`. A function that may be the
// entry point of another shader in the file is not warned of, unless this shader calls it.
void CheckUnusedClipPlanes(Context& context, const AttributeLists& of_entry);

}  // namespace clipc::check
