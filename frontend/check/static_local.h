// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// The static variables of functions. A value that is the same wherever it is computed, of constants
// and uniforms, is the variable's initial one. Any other is computed when control first reaches the
// declaration, as by dxc:
//
//   static float n = x;  =>  static bool n_is_set = false;
//                            if (!n_is_set) { n = x; n_is_set = true; }
//
// Up to profile 5.1 a value that reads a parameter or a variable of the function is an error
// (X3011): fxc does not accept `static const float v = val;` of a parameter (glslang's issue 1432,
// by an author of DXC, for which v keeps the value of the first call).
namespace clipc::check {

// Checks the declaration of a static variable, which only its function can name.
void CheckStaticLocal(Context& context, ast::DeclId id, const ast::VarDecl& var);

// Makes local variables of those whose declaration control reaches once at most, from `main` as
// FinishGlobals has made it. Requires a program without errors.
void SettleStaticLocals(Context& context);

}  // namespace clipc::check
