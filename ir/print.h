// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "ir/program.h"

// The program as text, for --dump=ir, --dump-after=PASS and the messages of Verify. It looks like
// HLSL, one declaration or statement a line without semicolons, and differs where HLSL leaves
// something unsaid:
// * what HLSL does implicitly has a name: convert<float3>(x), splat<float3>(x),
//   truncate<float3x3>(m), zero<Light>, select(c, a, b);
// * the operands of an object's operation that follow the place have their names:
//   texture_load(map, at, level: 0);
// * structs and arrays are made with braces: Light{a, b}, float[2]{a, b};
// * `a && b` evaluates both sides; the short-circuit forms are `a and_then b` and `a or_else b`;
// * literals show their kind: 1, 1u, 1.0, 1.0h, 1.0L, 1LL, 1:min16int, true.
// A second variable or function of the same name is printed as name.1, the next as name.2, in order
// of declaration. Equal programs give equal text.
namespace clipc::ir {

std::string Print(const Program& program);
std::string PrintExpr(const Program& program, ExprId expr);

}  // namespace clipc::ir
