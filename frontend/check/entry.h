// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Finding the entry point.
namespace clipc::check {

// The one function that the options name, the entry point; none after an error, which was reported.
// The name is looked up from global scope; a name without `::` that global scope does not have is
// also found when exactly one namespace has it. Prototypes do not count.
FunctionInfoId FindEntry(Context& context, const std::string& entry);

// The name of the symbol with its scopes: "NS::main".
std::string ScopedName(const Context& context, SymbolId id);

// Whether the function may be the entry point of another shader in the same file: its parameters or
// its result have semantics, their own or those of a struct's fields.
bool MayBeEntry(const Context& context, const ast::FunctionDecl& decl);

}  // namespace clipc::check
