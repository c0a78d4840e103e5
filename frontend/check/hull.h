// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/clip_planes.h"
#include "frontend/check/context.h"
#include "frontend/signature/build_main.h"

// What only a hull shader says: the function of the patch's constants, and how the patch is cut.
// Sources: "Tessellation Stages" and the pages of the attributes in Microsoft's HLSL reference; the
// rules of DXC's validator (META.MAXTESSFACTOR, SM.OUTPUTCONTROLPOINTCOUNTRANGE,
// SM.TRIOUTPUTPRIMITIVEMISMATCH, SM.ISOLINEOUTPUTPRIMITIVEMISMATCH).
namespace clipc::check {

// Reads the attributes of the entry point into program.tessellation, reaches the function that
// [patchconstantfunc] names, and returns its signature. Reports what is wrong with them. Does
// nothing in other stages. Requires that the entry's parameters were read.
EntrySignature ReadHull(Context& context, FunctionInfoId entry, const AttributeLists& attributes);

// Reports a function of constants that calls the entry point.
void CheckHull(Context& context);

// Gives static variables that the control point's code changes their first values again before the
// function of the constants runs: in Direct3D it runs by itself. Requires Program::globals.
void ResetStatics(Context& context);

}  // namespace clipc::check
