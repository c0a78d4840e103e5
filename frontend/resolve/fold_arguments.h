// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/resolve/names.h"

namespace clipc::resolve {

// Specialises the program by the constants that a technique gives to the entry's `uniform`
// parameters, `compile vs_3_0 Main(true, 4)`: the entry reads the constants, and so does every
// function that gets the same constant from all its calls. Where a condition is constant then, the
// branch that it does not choose is removed, with the calls in it. fxc does the same, so its rules
// about loops and derivatives ask only what is left.
//
//   float4 VS(float4 p, uniform bool fog) { if (fog) p.w += Fog(p); return p; }   // VS(false)
//       =>
//   float4 VS(float4 p, bool fog) { return p; }
//
// Requires a program without errors that has `main`.
void FoldArguments(Program& program);

// Where a `?:`, or an index into an array of local objects, chooses a texture, a sampler or a
// buffer, does the same for the constants of all calls, and for local variables that get one value,
// a constant: dxc takes such a choice if its condition is a constant then (its tests
// sel_sampler.hlsl and convergent_const_folding.hlsl), and fxc such an index (vkd3d's
// object-references.shader_test).
void FoldObjectChoices(Program& program);

// Removes from the body of a function what conditions that are constant do not choose. Local
// variables that get one value, a constant, count as constants.
void FoldBody(Program& program, StmtId body);

}  // namespace clipc::resolve
