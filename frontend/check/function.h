// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "frontend/check/context.h"

// Functions: their signatures and overload sets.
namespace clipc::check {

const ast::FunctionDecl& DeclOf(const Context& context, const FunctionInfo& info);
const ast::FunctionDecl& DeclOf(const Context& context, SymbolId function);
// Adds the function that the symbol declares, for objects of type `self` if it is a method.
// `instance` is the scope that holds the arguments of a template.
FunctionInfoId AddFunction(Context& context, SymbolId id, TypeId self, ScopeId instance = {});
// Resolves the types of the parameters and of the result, once.
void ResolveSignature(Context& context, FunctionInfoId id);
// Whether the parameters have the same types and directions.
bool SameParameters(const Context& context, const FunctionInfo& a, const FunctionInfo& b);
// All functions that have the name and scope of `first`, declared so far or later, except
// templates. A prototype and its definition are one function.
const KeptVector<FunctionInfoId>& OverloadsOf(Context& context, SymbolId first, TypeId self);
// The function of the name that can be called, even if it is declared later; none if there is no
// such function.
SymbolId FindFunction(Context& context, const ast::QualifiedName& name);
// A prototype inside a function: the functions of this name and number of parameters may be called
// after it, although they are declared later.
void DeclarePrototype(Context& context, const ast::FunctionDecl& decl);
// The signature as messages have it: "f(float, out int)".
std::string SignatureText(const Context& context, const FunctionInfo& info);

}  // namespace clipc::check
