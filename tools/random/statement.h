// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "tools/random/expr.h"

// Statements and functions of generated programs. Texts are whole lines.
namespace clipc::random {

// At most `most` statements in the scope that is open, of at most `depth` levels.
std::string MakeStatements(Context& context, int most, int depth);

// A type for a variable: a number, a vector, a matrix, an array or a struct.
Type MakeType(Context& context);
Shape MakeShape(Context& context);

// An initial value of that type, in braces or as an expression.
std::string MakeInitial(Context& context, const Type& type, int depth);

// `static float3 s1 = ...;`, `static const int c2[3] = ...;`
std::string MakeStatic(Context& context);
// A function, which may be called from then on.
std::string MakeFunction(Context& context);

}  // namespace clipc::random
