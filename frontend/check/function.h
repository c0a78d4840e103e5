// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "frontend/check/context.h"

// Functions: their signatures, overload sets and bodies.
namespace clipc::check {

const ast::FunctionDecl& DeclOf(const Context& context, const FunctionInfo& info);
void ResolveSignature(Context& context, FunctionInfoId id);
bool SameParameters(const Context& context, const FunctionInfo& a, const FunctionInfo& b);
// All functions of the name and scope of `first`, declared so far or not; templates are not among
// them.
std::vector<FunctionInfoId> OverloadsOf(Context& context, SymbolId first, ir::TypeId self);
std::string SignatureText(const Context& context, const FunctionInfo& info);

}  // namespace clipc::check
