// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "frontend/check/clip_planes.h"
#include "frontend/check/context.h"

// What hull and domain shaders say of a patch: "Tessellation Stages" and the pages of the
// attributes in Microsoft's HLSL reference; the Direct3D 11.3 functional specification, 10 to 12.
namespace clipc::check {

// The text of a string; nullopt for every other expression.
std::optional<std::string_view> StringOf(const Context& context, ast::ExprId id);
// The number of the word that the attribute has among `words`; nullopt after an error, and without
// the attribute. fxc compares words without case.
std::optional<std::size_t> WordIn(Context& context, const AttributeLists& attributes,
                                  std::string_view name, std::span<const std::string_view> words);

// Reads a parameter of the entry point that is a patch, `const OutputPatch<Point, 3> patch`, into
// program.tessellation. Returns whether the stage reads such a patch; reports it otherwise.
bool ReadPatch(Context& context, const ast::VarDecl& var, const Parameter& parameter);

// Reports a patch of a kind that a parameter of `function` before it has (DXC: "may only have one
// InputPatch parameter").
void ReportSecondPatch(Context& context, const ast::VarDecl& var, FunctionId function);

// Reports an attribute of an entry point that is repeated with another value: [domain("tri")]
// [domain("quad")]. `lists` are those of the function and its prototypes.
void CheckRepeated(Context& context, const AttributeLists& lists);

// Reads [domain(..)] and the like of the entry point into program.tessellation, and reports what is
// wrong with it. A domain shader gets the partitioning and the topology that the hull shaders of
// the file with its domain have, if they agree. Does nothing in other stages.
void CheckTessellation(Context& context, FunctionInfoId entry, const AttributeLists& attributes);

}  // namespace clipc::check
